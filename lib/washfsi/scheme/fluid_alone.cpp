// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/scheme/fluid_alone.hpp"

#include "washfsi/scheme/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
void FluidAlone<Dim>::take(System<Dim>& system, double dt) {
  hold_bodies(system, system.state.clock.time + dt);
  move_water(system, dt);
  system.model.fluid.finish();
}

template class FluidAlone<2>;
template class FluidAlone<3>;

}  // namespace washfsi
