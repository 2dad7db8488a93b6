// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/acceleration.hpp"

namespace washfsi {

template <int Dim>
Acceleration<Dim> backward_difference(const System<Dim>& system, double dt) {
  const State<Dim>& state = system.state;
  const double dt_before = system.model.fluid.last_step(), ratio = dt_before > 0 ? dt / dt_before : 1;
  return {(1 + 2 * ratio) / (1 + ratio) / dt,
          (1 / dt) * ((1 + ratio) * state.velocities - (ratio * ratio / (1 + ratio)) * state.velocities_before)};
}

template <int Dim>
Acceleration<Dim> trapezoidal_difference(const System<Dim>& system, double dt) {
  return {2 / dt, (2 / dt) * system.state.velocities};
}

namespace {

// (V^(n+1) - W)/(W - W^(n-1)). The first step, backward Euler, has its velocity at its end.
template <int Dim>
double extrapolation(const System<Dim>& system, double dt) {
  const double dt_before = system.model.fluid.last_step();
  if (dt_before == 0) return 0;
  return system.state.clock.step == 1 ? 1 : dt / (dt + dt_before);
}

}  // namespace

template <int Dim>
Acceleration<Dim> centred_difference(const System<Dim>& system, double dt) {
  const State<Dim>& state = system.state;
  const double beyond = extrapolation(system, dt);
  return {(1 + beyond) / dt, (1 / dt) * (state.velocities + beyond * state.mean_velocities)};
}

template <int Dim>
Points<Dim> extrapolated(const System<Dim>& system, double dt, const Points<Dim>& mean_velocities) {
  const double beyond = extrapolation(system, dt);
  return (1 + beyond) * mean_velocities - beyond * system.state.mean_velocities;
}

template Acceleration<2> backward_difference<2>(const System<2>&, double);
template Acceleration<3> backward_difference<3>(const System<3>&, double);
template Acceleration<2> trapezoidal_difference<2>(const System<2>&, double);
template Acceleration<3> trapezoidal_difference<3>(const System<3>&, double);
template Acceleration<2> centred_difference<2>(const System<2>&, double);
template Acceleration<3> centred_difference<3>(const System<3>&, double);
template Points<2> extrapolated<2>(const System<2>&, double, const Points<2>&);
template Points<3> extrapolated<3>(const System<3>&, double, const Points<3>&);

}  // namespace washfsi
