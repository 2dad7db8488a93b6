// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/cloth_alone.hpp"

#include "washfsi/coupling/coupling_operations.hpp"

namespace washfsi {

namespace {

template <int Dim>
void half_step(System<Dim>& system, double dt, double time) {
  auto& [model, state, step] = system;
  begin_explicit_step(system, state.positions, time, dt);
  const Points<Dim> forces = all_forces(system, state.positions);
  for (std::size_t m = 0; m < forces.size(); ++m) {
    const double mass = model.cloths.marker_masses()[m],
                 drag = model.cloth_treatment.drag * model.cloths.marker_areas()[m];
    state.velocities[m] = (mass * state.velocities[m] + 0.5 * dt * forces[m]) / (mass + 0.5 * dt * drag);
  }
}

}  // namespace

template <int Dim>
void ClothAlone<Dim>::advance_fields(System<Dim>& system, double dt) {
  State<Dim>& state = system.state;
  half_step(system, dt, state.clock.time);
  const Points<Dim> motion = dt * state.velocities, end = moved(system, motion);
  for (std::size_t m = 0; m < end.size(); ++m)
    if (end[m] != state.positions[m] + motion[m]) state.velocities[m] = (1 / dt) * (end[m] - state.positions[m]);
  state.positions = end;
  half_step(system, dt, state.clock.time + dt);
}

template class ClothAlone<2>;
template class ClothAlone<3>;

}  // namespace washfsi
