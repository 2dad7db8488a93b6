// SPDX-License-Identifier: BSD-3-Clause
//
// The barrier of Li et al., ACM Trans. Graph. 39 (2020) 49, of the distance y over that at which contact begins:
//   b(y) = -(y - 1)^2 ln y   for y < 1, else 0
// It is convex, with two continuous derivatives, and grows without bound as y goes to 0.
#pragma once

#include <cmath>
#include <limits>

#include "washfsi/contact/gap.hpp"

namespace washfsi {

struct BarrierValue {
  double value = 0, first = 0, second = 0;  ///< b(y), b' and b''
};

inline BarrierValue barrier(double s) {
  if (s >= 1) return {};
  if (s <= 0) return {std::numeric_limits<double>::infinity(), 0, 0};
  const double r = s - 1, log = std::log(s);
  return {-r * r * log, -2 * r * log - r * r / s, -2 * log - 4 * r / s + r * r / (s * s)};
}

/// The factor that fades out the barrier of two nearly parallel edges l and l', whose nearest points jump from end to
/// end:
///   eta(y) = (2 - y) y   for y = |l x l'|^2/eps < 1, else 1,     eps = 10^-2 |l_0|^2 |l_0'|^2 (`FacetPair::parallel`)
struct Mollifier {
  double value = 1;
  PairPoints<3> gradient{Point<3>::Zero(), Point<3>::Zero(), Point<3>::Zero(), Point<3>::Zero()};
};

inline Mollifier mollifier(const PairPoints<3>& places, double eps) {
  const Point<3> e = places[1] - places[0], f = places[3] - places[2];
  const double c = e.cross(f).squaredNorm(), part = c / eps;
  if (part >= 1) return {};
  const double slope = 2 * (1 - part) / eps, ef = e.dot(f);
  const Point<3> of_e = 2 * slope * (f.squaredNorm() * e - ef * f), of_f = 2 * slope * (e.squaredNorm() * f - ef * e);
  return {(2 - part) * part, {-of_e, of_e, -of_f, of_f}};
}

}  // namespace washfsi
