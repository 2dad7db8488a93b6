// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/flow_measure.hpp"

#include "washfsi/measure/carried_mass.hpp"

namespace washfsi {

template <int Dim>
void FlowMeasure<Dim>::declare(QuantityList& quantities) {
  using U = Units<Dim>;
  const FractionalStep<Dim>& fluid = system_.model.fluid;
  quantities.add({"time", "s", "at the end of the step", [this] { return system_.state.clock.time; }});
  quantities.add({"dt", "s", "length of the step", [this] { return dt_; }});
  quantities.add({"cfl", "-", "largest dt sum_d \\|u_d\\|/h_d over all cells", [this] { return flow_.courant.value; },
                  Accumulation::largest, "/max_cfl"},
                 {{"cfl", "-", OverCycle::peak, "largest CFL number"}});
  quantities.add(
      {"kinetic_energy", U::energy, "1/2 sum rho \\|u\\|² over the faces in fluid, and that of the cloths' mass",
       [this] { return flow_.kinetic_energy; }},
      {{"kinetic_energy_change", U::energy, OverCycle::change, "kinetic energy kept", -1}});
  quantities.add({"max_divergence", "1/s", "largest divergence of a cell; what the pressure solver left",
                  [this] { return flow_.max_divergence; }, Accumulation::largest, "/max_divergence"});
  quantities.add({"angular_momentum", U::angular_momentum,
                  "sum rho (x v - y u) over the faces in fluid, and that of the cloths' mass, about the vertical in "
                  "the box's middle",
                  [this] { return flow_.angular_momentum; }});
  quantities.add(
      {"dissipation", U::power, "2 mu e:e over the fluid, e the rate of strain", [this] { return flow_.dissipation; }},
      {{"dissipated", U::energy, OverCycle::integral, "energy lost to the water's friction", -1}});
  if (fluid.advection().scheme().departs_from_central())
    quantities.add(
        {"numerical_dissipation", U::power,
         "power that the advection scheme took out of the flow beyond central differences",
         [&fluid] { return fluid.advection().numerical_dissipation(); }},
        {{"advection_dissipated", U::energy, OverCycle::integral, "energy lost to the advection scheme", -1}});
}

template <int Dim>
void FlowMeasure<Dim>::observe(const Observation<Dim>& seen) {
  const Model<Dim>& model = system_.model;
  dt_ = seen.dt;
  // In direct forcing there is water behind walls too: that in the first half cell counts for dissipation.
  const double dry_fraction = model.bodies.dry_fraction();
  flow_ = FlowDiagnostics<Dim>::of(
      model.grid, {seen.velocity, model.liquid.fields(), model.bodies.fluid_share(), dry_fraction}, dt_);
  if (model.bodies.wall_law())
    flow_.dissipation += model.bodies.wall_law()->dissipation(model.fluid.velocity_before(), model.fluid.velocity(),
                                                              system_.state.clock.time);
  const CarriedMass cloth = CarriedMass::of(system_);
  flow_.kinetic_energy += cloth.kinetic_energy;
  flow_.angular_momentum += cloth.angular_momentum;
}

template <int Dim>
void FlowMeasure<Dim>::observe_start(const Observation<Dim>& seen) {
  observe(seen);
  flow_.max_divergence = 0;
}

template class FlowMeasure<2>;
template class FlowMeasure<3>;

}  // namespace washfsi
