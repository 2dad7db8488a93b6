// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/marker_samples.hpp"

namespace washfsi {

namespace {

template <int Dim>
std::vector<WashingAction> washing_action(const System<Dim>& system) {
  std::vector<WashingAction> actions(system.state.positions.size());
  if (!system.model.has_fluid) return actions;
  const Points<Dim> normals = washfsi::normals(system.model.cloths, system.state.positions);
  const GhostedVelocity<Dim> local(system.model.boundary, system.model.grid.wide_face_dm(),
                                   system.model.fluid.velocity(), system.state.clock.time);
  // within `sample_reach` along each axis, cells being flat or not; 0 where there is no normal
  const auto distance = [&](const Point<Dim>& normal) {
    const double cells = normal.cwiseQuotient(system.model.grid.spacing()).norm();
    return cells > 0 ? Transfer<Dim>::sample_reach / cells : 0.0;
  };
  for (const double side : {-1.0, 1.0}) {
    Points<Dim> offsets;
    for (const auto& normal : normals) offsets.push_back(side * distance(normal) * normal);
    const Points<Dim> water = system.model.transfer.sample(local, offsets);
    for (std::size_t m = 0; m < normals.size(); ++m) {
      const Point<Dim> relative = water[m] - system.state.velocities[m];
      actions[m].relative_speed += 0.5 * (relative - relative.dot(normals[m]) * normals[m]).norm();
    }
  }
  for (std::size_t m = 0; m < normals.size(); ++m)
    if (distance(normals[m]) > 0)
      actions[m].shear = system.model.liquid.pure().viscosity * actions[m].relative_speed / distance(normals[m]);
  return actions;
}

}  // namespace

template <int Dim>
std::vector<MarkerSample> marker_samples(const System<Dim>& system) {
  const std::vector<MarkerState> states = marker_states(system.model.cloths, system.state.positions);
  const std::vector<WashingAction> actions = washing_action(system);
  std::vector<MarkerSample> samples;
  for (std::size_t m = 0; m < states.size(); ++m) samples.push_back({states[m], actions[m]});
  return samples;
}

template std::vector<MarkerSample> marker_samples<2>(const System<2>&);
template std::vector<MarkerSample> marker_samples<3>(const System<3>&);

}  // namespace washfsi
