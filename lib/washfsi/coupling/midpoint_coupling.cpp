// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/midpoint_coupling.hpp"

#include "washfsi/coupling/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
void MidpointCoupling<Dim>::advance_fields(System<Dim>& system, double dt) {
  auto& [model, state, step] = system;
  const double time = state.clock.time;
  const Points<Dim> middle = moved(system, 0.5 * dt * state.velocities);
  begin_explicit_step(system, middle, time + 0.5 * dt, dt);
  spread_cloth(system, all_forces(system, middle));
  const Points<Dim> before = marker_velocities(model, model.fluid.velocity(), time);

  place_bodies(system, time + dt);
  move_water(system, dt);
  model.water_step().finish();

  const Points<Dim> after = marker_velocities(model, model.fluid.velocity(), time + dt);
  state.positions = moved(system, 0.5 * dt * (before + after));
  model.transfer.locate(state.positions);
  state.velocities = marker_velocities(model, model.fluid.velocity(), time + dt);
}

template class MidpointCoupling<2>;
template class MidpointCoupling<3>;

}  // namespace washfsi
