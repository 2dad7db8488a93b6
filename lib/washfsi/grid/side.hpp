// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "washfsi/support/point.hpp"

namespace washfsi {

enum class BoundaryKind { wall, slip, inflow, outflow, periodic };

enum class End { lower, upper };

/// How an inflow is distributed: evenly, or as a parabola that vanishes at the no-slip walls beside it and has the
/// given velocity as its peak.
enum class InflowProfile { uniform, parabolic };

/// What holds on one side of the box.
template <int Dim>
struct Side {
  BoundaryKind kind = BoundaryKind::wall;
  Point<Dim> velocity = Point<Dim>::Zero();        ///< of wall or inflow [m/s]; slip uses the normal component only
  InflowProfile profile = InflowProfile::uniform;  ///< of an inflow
  /// If set, the velocity [m/s] at a place [m] and time [s], instead of `velocity` and `profile`.
  std::function<Point<Dim>(const Point<Dim>&, double)> motion;
};

}  // namespace washfsi
