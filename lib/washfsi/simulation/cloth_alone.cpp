// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/cloth_alone.hpp"

#include "washfsi/simulation/coupling_operations.hpp"

namespace washfsi {

namespace {

template <int Dim>
void half_step(System<Dim>& system, double dt, double time) {
  const Cloths<Dim>& cloths = system.cloths;
  const Points<Dim> forces = all_forces(system, system.positions, system.velocities, time);
  for (std::size_t m = 0; m < forces.size(); ++m) {
    const double mass = cloths.marker_masses()[m], drag = system.cloth_drag * cloths.marker_areas()[m];
    system.velocities[m] = (mass * system.velocities[m] + 0.5 * dt * forces[m]) / (mass + 0.5 * dt * drag);
  }
}

}  // namespace

template <int Dim>
void ClothAlone<Dim>::advance(System<Dim>& system, double dt) {
  half_step(system, dt, system.fluid.time());
  system.positions = sum<Dim>(system.positions, dt, system.velocities);
  system.fluid.pass(dt);
  half_step(system, dt, system.fluid.time());
}

template class ClothAlone<2>;
template class ClothAlone<3>;

}  // namespace washfsi
