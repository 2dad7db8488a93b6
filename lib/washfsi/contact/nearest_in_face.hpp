// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// The place in a face where the distance from a body is least.
template <int Dim>
struct NearestInFace {
  std::array<double, Dim> shares;  ///< shares of the corners
  double distance;                 ///< [m]; infinite if it cannot be below the limit
};

/// Finds that place by a compass search: from the best of the corners, the middles of the edges and that of the face,
/// along the edges, with steps that are halved. distance(place) must be a lower bound in size of a signed distance, so
/// that places farther than the limit plus the remaining steps are skipped. `at_corners` are its values there.
template <int Dim, class Distance>
NearestInFace<Dim> nearest_in_face(const std::array<Point<Dim>, Dim>& corners,
                                   const std::array<double, Dim>& at_corners, double limit, const Distance& distance) {
  using Shares = std::array<double, Dim>;
  constexpr double first_way = 0.25, last_way = 1.0 / 64;
  double longest = 0;
  for (std::size_t i = 0; i < Dim; ++i)
    for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, (corners[i] - corners[j]).norm());
  NearestInFace<Dim> best{{}, INFINITY};
  const auto take_if_nearer = [&](const Shares& shares, double value) {
    if (value < best.distance) best = {shares, value};
  };
  const auto look = [&](const Shares& shares) {
    Point<Dim> place = Point<Dim>::Zero();
    for (std::size_t i = 0; i < Dim; ++i) place += shares[i] * corners[i];
    take_if_nearer(shares, distance(place));
  };
  Shares middle;
  middle.fill(1.0 / Dim);
  look(middle);
  if (best.distance > limit + longest) return {middle, INFINITY};
  for (std::size_t i = 0; i < Dim; ++i) {
    Shares corner{};
    corner[i] = 1;
    take_if_nearer(corner, at_corners[i]);
    if constexpr (Dim == 3) {
      Shares edge{};
      edge[i] = edge[(i + 1) % 3] = 0.5;
      look(edge);
    }
  }
  for (double way = first_way; way >= last_way;) {
    const NearestInFace<Dim> before = best;
    for (std::size_t from = 0; from < Dim; ++from)
      for (std::size_t to = 0; to < Dim; ++to) {
        if (from == to) continue;
        Shares shares = before.shares;
        const double part = std::min(way, shares[from]);
        if (part == 0) continue;
        shares[from] -= part;
        shares[to] += part;
        look(shares);
      }
    if (best.distance < before.distance) continue;
    way *= 0.5;
    if (best.distance > limit + 4 * way * longest) return {best.shares, INFINITY};
  }
  return best;
}

}  // namespace washfsi
