// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/wale.hpp"

#include <cmath>

namespace washfsi {

Wale::Wale(double constant, const Point<3>& sides) : square_(std::pow(constant * std::cbrt(sides.prod()), 2)) {}

// By roots: s^2 = e : e and t^4 = Lambda : Lambda.
double Wale::operator()(const Gradient<3>& gradient) const {
  const Gradient<3> square = gradient * gradient, strain = 0.5 * (gradient + gradient.transpose());
  const Gradient<3> deviator = 0.5 * (square + square.transpose()) - square.trace() / 3 * Gradient<3>::Identity();
  const double s = strain.norm(), t = std::sqrt(deviator.norm());
  const double s2 = s * s, t2 = t * t, below = s2 * s2 * s + t2 * t2 * t;
  return below > 0 ? square_ * t2 * t2 * t2 / below : 0;
}

}  // namespace washfsi
