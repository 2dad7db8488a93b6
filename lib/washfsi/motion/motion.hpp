// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "washfsi/motion/motion_table.hpp"
#include "washfsi/motion/speed_programme.hpp"
#include "washfsi/shapes/pose.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// A rigid motion: rotation about a centre (about z in 3D) and translation of the centre. Both are steady. Or both
/// oscillate: the angular velocity is Omega = Omega_max sin(omega t) with omega = 2 pi `frequency` (5.4-1), and the
/// velocity of the centre likewise. Or a table gives both, or the rotation follows a programme of speeds while the
/// centre rests. A function of time alone.
template <int Dim>
struct RigidMotion {
  using Pose = washfsi::Pose<Dim>;

  Point<Dim> center = Point<Dim>::Zero();       ///< centre at t = 0, from which the table's displacements count [m]
  double angular_speed = 0;                     ///< Omega, or Omega_max [rad/s]
  double frequency = 0;                         ///< omega/(2 pi) [Hz]; 0: steady
  Point<Dim> translation = Point<Dim>::Zero();  ///< velocity of the centre, or its largest value [m/s]
  std::shared_ptr<const MotionTable<Dim>> table = nullptr;    ///< instead of speeds and frequency
  std::shared_ptr<const SpeedProgramme> programme = nullptr;  ///< instead of both

  /// The options of one body. Errors: InputError. Collective.
  static RigidMotion from_options(Options& options, const std::string& name);

  /// Position and rates of the frame at one moment.
  struct State {
    Point<Dim> center, velocity, acceleration;             ///< centre, its velocity and acceleration [m, m/s, m/s2]
    double angle, angular_velocity, angular_acceleration;  ///< [rad, rad/s, rad/s2]

    /// Velocity and acceleration of the body's material at a place; for many places at one moment.
    Point<Dim> velocity_at(const Point<Dim>& place) const;
    Point<Dim> acceleration_at(const Point<Dim>& place) const;
  };
  State state(double time) const;

  /// Whether the body never moves.
  bool at_rest() const;
  /// Whether it only turns, always at `angular_speed`.
  bool turns_steadily() const { return !table && !programme && frequency == 0 && translation.isZero(0); }
  /// Whether the centre never moves.
  bool only_turns() const { return table ? table->only_turns() : programme || translation.isZero(0); }
  /// Whether it ever turns.
  bool turns() const { return largest_speed(1) > largest_speed(0); }
  /// Period of the motion [s]; 0 if it does not repeat, as a steady one.
  double period() const;
  /// The shortest time that steps have to resolve, and the option that gives it; infinite for a steady motion.
  SpeedProgramme::Span shortest_span() const;
  Point<Dim> center_at(double time) const { return state(time).center; }  ///< [m]
  double angle(double time) const { return state(time).angle; }           ///< since t = 0, or as the table says [rad]
  double angular_velocity(double time) const { return state(time).angular_velocity; }          ///< [rad/s]
  double angular_acceleration(double time) const { return state(time).angular_acceleration; }  ///< [rad/s2]

  /// Velocity and acceleration of the body's material at a place.
  Point<Dim> velocity(const Point<Dim>& place, double time) const { return state(time).velocity_at(place); }
  Point<Dim> acceleration(const Point<Dim>& place, double time) const { return state(time).acceleration_at(place); }
  /// A speed that the material which is at a distance [m] from the centre never exceeds [m/s].
  double largest_speed(double arm) const;

  /// The body's frame at one moment, for many places: its origin is the centre.
  Pose pose(double time) const;
  Point<Dim> in_body_frame(const Point<Dim>& place, double time) const { return pose(time).in_body_frame(place); }
};

extern template struct RigidMotion<2>;
extern template struct RigidMotion<3>;

}  // namespace washfsi
