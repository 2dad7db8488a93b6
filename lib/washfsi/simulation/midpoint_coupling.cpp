// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/midpoint_coupling.hpp"

#include "washfsi/simulation/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
void MidpointCoupling<Dim>::advance(System<Dim>& system, double dt) {
  const double time = system.fluid.time();
  const Points<Dim> middle = sum<Dim>(system.positions, 0.5 * dt, system.velocities);
  spread_cloth(system, middle, all_forces(system, middle, system.velocities, time + 0.5 * dt));
  const Points<Dim> before = marker_velocities<Dim>(system, system.fluid.velocity(), time);

  hold_bodies(system, time + dt);
  predict_and_project(system, dt);
  system.fluid.finish();

  const Points<Dim> after = marker_velocities<Dim>(system, system.fluid.velocity(), time + dt);
  system.positions = sum<Dim>(sum<Dim>(system.positions, 0.5 * dt, before), 0.5 * dt, after);
  system.transfer.locate(system.positions);
  system.velocities = marker_velocities<Dim>(system, system.fluid.velocity(), time + dt);
}

template class MidpointCoupling<2>;
template class MidpointCoupling<3>;

}  // namespace washfsi
