// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/motion.hpp"

#include <cmath>
#include <numbers>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

/// How far a motion of unit speed has come, and its rates.
struct Progress {
  double value, rate, acceleration;
};

Progress progress(double frequency, double time) {
  if (frequency == 0) return {time, 1, 0};
  const double omega = 2 * std::numbers::pi * frequency, phase = omega * time;
  return {(1 - std::cos(phase)) / omega, std::sin(phase), omega * std::cos(phase)};
}

}  // namespace

template <int Dim>
typename RigidMotion<Dim>::State RigidMotion<Dim>::state(double time) const {
  if (table) {
    const auto [value, rate, acceleration] = table->at(time);
    return {center + value.template head<Dim>(),
            rate.template head<Dim>(),
            acceleration.template head<Dim>(),
            value[Dim],
            rate[Dim],
            acceleration[Dim]};
  }
  const auto [value, rate, acceleration] = progress(frequency, time);
  return {center + value * translation, rate * translation,   acceleration * translation,
          angular_speed * value,        angular_speed * rate, angular_speed * acceleration};
}

template <int Dim>
bool RigidMotion<Dim>::at_rest() const {
  return table ? table->largest_rate().isZero(0) : angular_speed == 0 && translation.isZero(0);
}

template <int Dim>
Point<Dim> RigidMotion<Dim>::velocity(const Point<Dim>& place, double time) const {
  const State now = state(time);
  const Point<Dim> arm = place - now.center;
  const double omega = now.angular_velocity;
  Point<Dim> result = now.velocity;
  result.template head<2>() += omega * Point<2>(-arm[1], arm[0]);
  return result;
}

template <int Dim>
Point<Dim> RigidMotion<Dim>::acceleration(const Point<Dim>& place, double time) const {
  const State now = state(time);
  const Point<2> arm = (place - now.center).template head<2>();
  const double omega = now.angular_velocity, alpha = now.angular_acceleration;
  Point<Dim> result = now.acceleration;
  result.template head<2>() += alpha * Point<2>(-arm[1], arm[0]) - omega * omega * arm;
  return result;
}

template <int Dim>
double RigidMotion<Dim>::largest_speed(double arm) const {
  if (!table) return translation.norm() + std::abs(angular_speed) * arm;
  const auto rate = table->largest_rate();
  return rate.template head<Dim>().norm() + rate[Dim] * arm;
}

template <int Dim>
typename RigidMotion<Dim>::Pose RigidMotion<Dim>::pose(double time) const {
  const State now = state(time);
  return Pose::at(now.center, now.angle);
}

template <int Dim>
RigidMotion<Dim> RigidMotion<Dim>::from_options(Options& options, const std::string& name) {
  RigidMotion motion;
  std::string path;
  options.block(
      name + "_", "Motion of body " + name,
      [&](OptionBlock& block) {
        block.template point<Dim>("center", motion.center, "m", "place of the body's centre, about which it turns");
        block.real("angular_speed", motion.angular_speed, "rad/s", any_number,
                   "speed of rotation, or its largest value");
        block.template point<Dim>("velocity", motion.translation, "m/s",
                                  "velocity of the centre, or its largest value");
        block.real("frequency", motion.frequency, "Hz", non_negative, "of an oscillating motion; 0: steady");
        block.text("motion_file", path,
                   "table of the motion instead: time, x, y[, z], angle; the place is added to center");
      },
      "bodies_");
  if (path.empty()) return motion;
  const std::string option = "-" + name + "_motion_file";
  if (!motion.at_rest() || motion.frequency != 0)
    throw InputError(option + " " + path + ": cannot be combined with -" + name +
                     "_angular_speed, _velocity or _frequency");
  motion.table = std::make_shared<const MotionTable<Dim>>(MotionTable<Dim>::read(options.comm(), path, option));
  return motion;
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;

}  // namespace washfsi
