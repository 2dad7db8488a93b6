// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/point.hpp"

namespace washfsi {

/// A rigid rotation about a centre (about z in space): steady, or Omega(t) = Omega_max sin(2 pi f t) (5.4-1).
template <int Dim>
struct RigidMotion {
  Point<Dim> center = Point<Dim>::Zero();  ///< [m]
  double angular_speed = 0;                ///< Omega, or Omega_max [rad/s]
  double frequency = 0;                    ///< f [Hz]; 0: steady

  bool at_rest() const { return angular_speed == 0; }
  double angle(double time) const;                 ///< turned since t = 0 [rad]
  double angular_velocity(double time) const;      ///< [rad/s]
  double angular_acceleration(double time) const;  ///< [rad/s2]

  /// Velocity and acceleration of the body's material at a place.
  Point<Dim> velocity(const Point<Dim>& place, double time) const;
  Point<Dim> acceleration(const Point<Dim>& place, double time) const;
  /// The place in the body's own frame, which is at its centre and unturned at t = 0.
  Point<Dim> in_body_frame(const Point<Dim>& place, double time) const { return pose(time).in_body_frame(place); }

  /// The body's frame at one moment, for many places.
  struct Pose {
    Point<Dim> center;
    double cosine, sine;

    Point<Dim> in_body_frame(const Point<Dim>& place) const {
      Point<Dim> arm = place - center;
      arm.template head<2>() = Point<2>(cosine * arm[0] + sine * arm[1], -sine * arm[0] + cosine * arm[1]);
      return arm;
    }
  };
  Pose pose(double time) const;
};

extern template struct RigidMotion<2>;
extern template struct RigidMotion<3>;

}  // namespace washfsi
