// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/fluid_alone.hpp"

#include "washfsi/simulation/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
void FluidAlone<Dim>::advance(System<Dim>& system, double dt) {
  hold_bodies(system, system.fluid.time() + dt);
  predict_and_project(system, dt);
  system.fluid.finish();
}

template class FluidAlone<2>;
template class FluidAlone<3>;

}  // namespace washfsi
