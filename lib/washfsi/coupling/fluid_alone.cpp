// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/fluid_alone.hpp"

#include "washfsi/coupling/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
void FluidAlone<Dim>::advance_fields(System<Dim>& system, double dt) {
  place_bodies(system, system.state.clock.time + dt);
  move_water(system, dt);
  system.model.water_step().finish();
}

template class FluidAlone<2>;
template class FluidAlone<3>;

}  // namespace washfsi
