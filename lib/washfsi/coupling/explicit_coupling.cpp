// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/explicit_coupling.hpp"

#include "washfsi/coupling/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
void ExplicitCoupling<Dim>::advance_fields(System<Dim>& system, double dt) {
  auto& [model, state, step] = system;
  const double time = state.clock.time;
  begin_explicit_step(system, state.positions, time, dt);
  spread_cloth(system, all_forces(system, state.positions));

  place_bodies(system, time + dt);
  move_water(system, dt);
  model.water_step().finish();

  state.velocities = marker_velocities(model, model.fluid.velocity(), time + dt);
  state.positions = moved(system, dt * state.velocities);
}

template class ExplicitCoupling<2>;
template class ExplicitCoupling<3>;

}  // namespace washfsi
