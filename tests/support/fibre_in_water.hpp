// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/simulation/case.hpp"

namespace washfsi::test {

/// One fibre of 20 markers in a periodic box of water, 32 x 32 cells of 1 cm.
inline CaseOptions<2> fibre_in_water(double excess_mass, double damping) {
  CaseOptions<2> options;
  options.model.grid.shape.cells = {32, 32};
  options.model.grid.shape.upper = {0.32, 0.32};
  options.model.grid.shape.periodic = {true, true};
  for (auto& axis : options.model.grid.sides)
    for (auto& side : axis) side.kind = BoundaryKind::periodic;
  options.model.fluid.viscosity = 0.5;
  options.model.fluid.momentum_tolerance = 1e-13;
  options.model.fluid.pressure_tolerance = 1e-12;
  ClothGroup<2> group;
  group.name = "fibre";
  group.count = 1;
  group.markers = {20, 1};
  group.size = {0.2, 1};
  group.excess_mass = excess_mass;
  group.sheet = {
      .ds = 0.01, .fabric = LinearFabric({.ke_s = 1000, .kb_s = 1e-4}), .damping = damping, .thickness = 1e-3};
  options.model.cloths = {group};
  PlacementOptions<2> placement;
  placement.center = {0.16, 0.16};
  options.placements = {placement};
  return options;
}

/// Bends and stretches the fibre at rest.
inline void disturb(System<2>& system, double size) {
  Points<2>& positions = system.state.positions;
  const Cloths<2>& cloths = system.model.cloths;
  for (std::size_t m = 0; m < positions.size(); ++m) {
    const double s = static_cast<double>(cloths.number_of(m)) / static_cast<double>(cloths.marker_count());
    positions[m] += size * Point<2>(std::sin(9 * s), std::cos(7 * s) + std::sin(17 * s));
  }
}

inline double total_energy(const System<2>& system) {
  const Model<2>& model = system.model;
  const GhostedVelocity<2> velocity(model.boundary, model.grid.face_dm(), model.fluid.velocity(),
                                    system.state.clock.time);
  const auto flow = FlowDiagnostics<2>::of(model.grid, {velocity, {model.liquid.density(), {}}}, 1);
  return flow.kinetic_energy + model.forces.elastic_energies(system.state.positions)[0];
}

}  // namespace washfsi::test
