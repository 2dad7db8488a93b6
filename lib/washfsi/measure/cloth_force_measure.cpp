// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cloth_force_measure.hpp"

#include "washfsi/cloth/holding_springs.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
ClothForceMeasure<Dim>::ClothForceMeasure(const System<Dim>& system)
    : system_(system), by_water_(system.model.cloths.groups().size(), Point<Dim>::Zero()), by_springs_(by_water_) {
  for (const auto& force : system.model.forces.list())
    if (dynamic_cast<const HoldingSprings<Dim>*>(force.get())) springs_ = force.get();
}

template <int Dim>
void ClothForceMeasure<Dim>::declare(QuantityList& quantities) {
  const auto& groups = system_.model.cloths.groups();
  const auto declare_force = [&](const std::string& name, const Points<Dim>& forces, std::size_t g,
                                 const char* meaning) {
    for (int d = 0; d < Dim; ++d)
      quantities.add(
          {name + "_force_" + "xyz"[d], Units<Dim>::force, meaning, [&forces, g, d] { return forces[g][d]; }});
  };
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].held_markers().empty()) continue;  // the sum of a free cloth's forces is round-off
    if (system_.model.has_fluid)
      declare_force(groups[g].name + "_water", by_water_, g, "force of the water on the group's cloths");
    declare_force(groups[g].name + "_hold", by_springs_, g,
                  "force of the holding springs on the group's cloths, mean over the step");
  }
}

template <int Dim>
Points<Dim> ClothForceMeasure<Dim>::sums_of_groups(const Points<Dim>& forces) const {
  const Cloths<Dim>& cloths = system_.model.cloths;
  std::vector<double> sums(by_water_.size() * Dim, 0.0);
  for (std::size_t m = 0; m < forces.size(); ++m)
    for (int d = 0; d < Dim; ++d) sums[cloths.group_number(m) * Dim + d] += forces[m][d];
  sums = ordered_sum(cloths.comm(), sums);
  Points<Dim> by_group(by_water_.size());
  for (std::size_t g = 0; g < by_group.size(); ++g) by_group[g] = Point<Dim>(&sums[g * Dim]);
  return by_group;
}

// Springs are linear: their mean force over the step is the one at the mean place.
template <int Dim>
void ClothForceMeasure<Dim>::observe(const Observation<Dim>& seen) {
  const auto& [model, state, step] = system_;
  by_water_ = sums_of_groups(-1.0 * step.force_on_water);
  const double start_share = 1 - step.end_share;
  Points<Dim> forces(model.cloths.owned(), Point<Dim>::Zero());
  springs_->add_force(step.evaluated_at - start_share * seen.dt * state.mean_velocities, {}, forces);
  by_springs_ = sums_of_groups(forces);
}

template class ClothForceMeasure<2>;
template class ClothForceMeasure<3>;

}  // namespace washfsi
