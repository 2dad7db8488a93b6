// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/inertia.hpp"

namespace washfsi {

template <int Dim>
void Inertia<Dim>::begin_step(const StepStart<Dim>& start) {
  const auto& [rate, known] = start.acceleration;
  stiffness_per_mass_ = rate > 0 ? rate / (start.dt * start.share) : 0;
  unmoved_ = start.positions;
  if (rate > 0) unmoved_ += (start.dt / rate) * known;
}

template <int Dim>
void Inertia<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  for (std::size_t m = 0; m < forces.size(); ++m)
    forces[m] -= cloths_.marker_masses()[m] * stiffness_per_mass_ * (positions[m] - unmoved_[m]);
}

template <int Dim>
void Inertia<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  for (std::size_t m = 0; m < positions.size(); ++m)
    of_groups[cloths_.group_number(m)] +=
        0.5 * cloths_.marker_masses()[m] * stiffness_per_mass_ * (positions[m] - unmoved_[m]).squaredNorm();
}

template <int Dim>
void Inertia<Dim>::add_force_rates(const Points<Dim>&, const Points<Dim>& direction, Points<Dim>& rates) const {
  for (std::size_t m = 0; m < rates.size(); ++m)
    rates[m] -= cloths_.marker_masses()[m] * stiffness_per_mass_ * direction[m];
}

template <int Dim>
void Inertia<Dim>::visit_stiffness(const Points<Dim>&, GeometricStiffness, const AddMarkerBlock<Dim>& add) const {
  for (std::size_t m = 0; m < cloths_.owned(); ++m) {
    const PetscInt marker = cloths_.number_of(m);
    add(marker, marker, cloths_.marker_masses()[m] * stiffness_per_mass_ * StiffnessBlock<Dim>::Identity());
  }
}

template <int Dim>
void Inertia<Dim>::add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const {
  for (std::size_t m = 0; m < sizes.size(); ++m)
    sizes[m] += cloths_.marker_masses()[m] * stiffness_per_mass_ * positions[m].norm();
}

template class Inertia<2>;
template class Inertia<3>;

}  // namespace washfsi
