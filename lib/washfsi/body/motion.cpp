// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/motion.hpp"

#include <cmath>
#include <numbers>

namespace washfsi {

template <int Dim>
double RigidMotion<Dim>::angle(double time) const {
  if (frequency == 0) return angular_speed * time;
  const double rate = 2 * std::numbers::pi * frequency;
  return angular_speed / rate * (1 - std::cos(rate * time));
}

template <int Dim>
double RigidMotion<Dim>::angular_velocity(double time) const {
  return frequency == 0 ? angular_speed : angular_speed * std::sin(2 * std::numbers::pi * frequency * time);
}

template <int Dim>
double RigidMotion<Dim>::angular_acceleration(double time) const {
  const double rate = 2 * std::numbers::pi * frequency;
  return frequency == 0 ? 0 : angular_speed * rate * std::cos(rate * time);
}

template <int Dim>
Point<Dim> RigidMotion<Dim>::velocity(const Point<Dim>& place, double time) const {
  const Point<Dim> arm = place - center;
  const double omega = angular_velocity(time);
  Point<Dim> result = Point<Dim>::Zero();
  result.template head<2>() << -omega * arm[1], omega * arm[0];
  return result;
}

template <int Dim>
Point<Dim> RigidMotion<Dim>::acceleration(const Point<Dim>& place, double time) const {
  const Point<Dim> arm = place - center;
  const double omega = angular_velocity(time), alpha = angular_acceleration(time);
  Point<Dim> result = Point<Dim>::Zero();
  result.template head<2>() << -alpha * arm[1] - omega * omega * arm[0], alpha * arm[0] - omega * omega * arm[1];
  return result;
}

template <int Dim>
typename RigidMotion<Dim>::Pose RigidMotion<Dim>::pose(double time) const {
  return {center, std::cos(angle(time)), std::sin(angle(time))};
}

template struct RigidMotion<2>;
template struct RigidMotion<3>;

}  // namespace washfsi
