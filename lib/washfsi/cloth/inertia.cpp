// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/inertia.hpp"

namespace washfsi {

template <int Dim>
void Inertia<Dim>::begin_step(const StepStart<Dim>& start) {
  dt_ = start.dt;
  if (start.dt == 0) {
    last_accelerations_.assign(start.positions.size(), Point<Dim>::Zero());
    if (start.dt_before > 0) last_accelerations_ = (1 / start.dt_before) * (start.velocities - start.velocities_before);
    return;
  }
  weight_ = start.weight;
  const double ratio = start.dt_before > 0 && start.weight == 1 ? start.dt / start.dt_before : 0;
  factor_ = (1 + 2 * ratio) / (1 + ratio);
  const double now = (1 + ratio) / factor_, before = ratio * ratio / (1 + ratio) / factor_;
  unmoved_.resize(start.positions.size());
  for (std::size_t m = 0; m < unmoved_.size(); ++m) {
    const Point<Dim> steady = now * start.velocities[m] - before * start.velocities_before[m];
    unmoved_[m] = start.positions[m] + dt_ * (start.velocities[m] + weight_ * (steady - start.velocities[m]));
  }
}

template <int Dim>
void Inertia<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  const std::vector<double>& masses = cloths_.marker_masses();
  for (std::size_t m = 0; m < forces.size(); ++m)
    forces[m] -= masses[m] *
                 (dt_ == 0 ? last_accelerations_[m] : Point<Dim>(stiffness_per_mass() * (positions[m] - unmoved_[m])));
}

template <int Dim>
void Inertia<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  if (dt_ == 0) return;
  for (std::size_t m = 0; m < positions.size(); ++m)
    of_groups[cloths_.group_number(m)] +=
        0.5 * cloths_.marker_masses()[m] * stiffness_per_mass() * (positions[m] - unmoved_[m]).squaredNorm();
}

template <int Dim>
void Inertia<Dim>::add_force_rates(const Points<Dim>&, const Points<Dim>& direction, Points<Dim>& rates) const {
  if (dt_ == 0) return;
  for (std::size_t m = 0; m < rates.size(); ++m)
    rates[m] -= cloths_.marker_masses()[m] * stiffness_per_mass() * direction[m];
}

template <int Dim>
void Inertia<Dim>::visit_stiffness(const Points<Dim>&, GeometricStiffness, const AddMarkerBlock<Dim>& add) const {
  const double per_mass = dt_ > 0 ? stiffness_per_mass() : 0;
  for (std::size_t m = 0; m < cloths_.owned(); ++m) {
    const PetscInt marker = cloths_.number_of(m);
    add(marker, marker, cloths_.marker_masses()[m] * per_mass * StiffnessBlock<Dim>::Identity());
  }
}

template <int Dim>
void Inertia<Dim>::add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const {
  if (dt_ == 0) return;
  for (std::size_t m = 0; m < sizes.size(); ++m)
    sizes[m] += cloths_.marker_masses()[m] * stiffness_per_mass() * positions[m].norm();
}

template class Inertia<2>;
template class Inertia<3>;

}  // namespace washfsi
