// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/explicit_coupling.hpp"

#include "washfsi/simulation/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
void ExplicitCoupling<Dim>::advance(System<Dim>& system, double dt) {
  const double time = system.fluid.time();
  spread_cloth(system, system.positions, all_forces(system, system.positions, system.velocities, time));

  hold_bodies(system, time + dt);
  predict_and_project(system, dt);
  system.fluid.finish();

  system.velocities = marker_velocities<Dim>(system, system.fluid.velocity(), system.fluid.time());
  system.positions = sum<Dim>(system.positions, dt, system.velocities);
}

template class ExplicitCoupling<2>;
template class ExplicitCoupling<3>;

}  // namespace washfsi
