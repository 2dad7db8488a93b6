// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/gap.hpp"

namespace washfsi {

/// Two parts of cloths that face each other, a point of each: sum of shares X = distance times normal, over the markers
/// that these points lie between. The shares of the first part are positive and sum up to 1, those of the second are
/// negative and sum up to -1; the gradient of the distance in marker i is shares[i] normal.
template <int Dim>
struct Facing {
  std::size_t count = 0;                       ///< number of markers
  std::array<std::size_t, 2 * Dim> markers{};  ///< indices among the markers that the rank knows
  std::array<double, 2 * Dim> shares{};        ///< shares of the markers
  double distance = 0;                         ///< [m]
  Point<Dim> normal = Point<Dim>::Zero();      ///< from the second part to the first

  void add(std::size_t marker, double share) {
    markers[count] = marker;
    shares[count++] = share;
  }
};

}  // namespace washfsi
