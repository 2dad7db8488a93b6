// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>

#include "washfsi/support/point.hpp"

namespace washfsi {

enum class BoundaryKind { wall, slip, inflow, outflow, periodic };

enum class End { lower, upper };

/// A side of the box.
struct SideName {
  int axis;
  End end;
};

/// How an inflow is distributed: evenly, or as a parabola that vanishes at the no-slip walls beside it and has the
/// given velocity as its peak.
enum class InflowProfile { uniform, parabolic };

/// The boundary condition on one side of the box.
template <int Dim>
struct Side {
  BoundaryKind kind = BoundaryKind::wall;
  Point<Dim> velocity = Point<Dim>::Zero();  ///< velocity of wall or inflow [m/s]; slip uses the normal component only
  InflowProfile profile = InflowProfile::uniform;  ///< profile of an inflow
  /// If set, the velocity [m/s] at a place [m] and time [s], instead of `velocity` and `profile`.
  std::function<Point<Dim>(const Point<Dim>&, double)> motion;
};

template <int Dim>
using Sides = std::array<std::array<Side<Dim>, 2>, Dim>;  ///< [axis][End]

template <int Dim>
const Side<Dim>& side_of(const Sides<Dim>& sides, int axis, End end) {
  return sides[axis][end == End::upper ? 1 : 0];
}

/// The share of the peak that a parabolic inflow across `axis` has at a place of a box: along each direction with
/// no-slip walls 0 there and 1 midway or at the far end.
template <int Dim>
double parabola(const Sides<Dim>& sides, int axis, const Point<Dim>& lower, const Point<Dim>& upper,
                const Point<Dim>& place) {
  double share = 1;
  for (int d = 0; d < Dim; ++d) {
    const bool from_lower = d != axis && sides[d][0].kind == BoundaryKind::wall;
    const bool from_upper = d != axis && sides[d][1].kind == BoundaryKind::wall;
    const double s = (place[d] - lower[d]) / (upper[d] - lower[d]);
    if (from_lower && from_upper)
      share *= 4 * s * (1 - s);
    else if (from_lower)
      share *= s * (2 - s);
    else if (from_upper)
      share *= (1 - s) * (1 + s);
  }
  return share;
}

}  // namespace washfsi
