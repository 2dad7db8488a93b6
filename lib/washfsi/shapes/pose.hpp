// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// The place of a frame in another one: its origin, and its turn about z.
template <int Dim>
struct Pose {
  Point<Dim> center = Point<Dim>::Zero();  ///< [m]
  double cosine = 1, sine = 0;             ///< cosine and sine of the angle of turn

  static Pose at(const Point<Dim>& center, double angle) { return {center, std::cos(angle), std::sin(angle)}; }

  Point<Dim> in_body_frame(const Point<Dim>& place) const {
    Point<Dim> arm = place - center;
    arm.template head<2>() = Point<2>(cosine * arm[0] + sine * arm[1], -sine * arm[0] + cosine * arm[1]);
    return arm;
  }
  Point<Dim> in_space(Point<Dim> arm) const {
    arm.template head<2>() = Point<2>(cosine * arm[0] - sine * arm[1], sine * arm[0] + cosine * arm[1]);
    return center + arm;
  }
  /// The outer place of a frame that is at `inner` in this one.
  Pose in_space(const Pose& inner) const {
    return {in_space(inner.center), cosine * inner.cosine - sine * inner.sine,
            sine * inner.cosine + cosine * inner.sine};
  }
};

}  // namespace washfsi
