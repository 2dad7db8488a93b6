// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/seepage.hpp"

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
Seepage<Dim>::Seepage(const Model<Dim>& model) : cloths_(model.cloths), present_(model.cloth_treatment.films_drain) {
  if (model.cloth_treatment.films_drain) films_.emplace(model.grid, cloths_, model.liquid);
  for (const auto& group : cloths_.groups()) present_ = present_ || group.permeance > 0;
  for (std::size_t m = 0; m < cloths_.owned(); ++m)
    rates_.push_back(cloths_.group_of(m).permeance / cloths_.marker_areas()[m]);
}

template <int Dim>
void Seepage<Dim>::begin_step(const Points<Dim>& positions, const Points<Dim>& forces) {
  if (films_) films_->begin_step(positions, forces);
}

template <int Dim>
Points<Dim> Seepage<Dim>::velocities(const Points<Dim>& forces) const {
  Points<Dim> result;
  for (std::size_t m = 0; m < forces.size(); ++m) result.push_back(rates_[m] * forces[m]);
  if (films_) films_->add_velocities(forces, result);
  return result;
}

template <int Dim>
double Seepage<Dim>::power(const Points<Dim>& forces) const {
  double sum = 0;
  for (std::size_t m = 0; m < forces.size(); ++m) sum += rates_[m] * forces[m].squaredNorm();
  return ordered_sum(cloths_.comm(), sum) + (films_ ? films_->power(forces) : 0);
}

template <int Dim>
void Seepage<Dim>::add_to(StepMobility<Dim>& mobility, double factor) const {
  if (!present_) return;
  if (films_) mobility.add(films_->matrix(factor));
  petsc::Matrix own;
  const auto rows = static_cast<PetscInt>(Dim * rates_.size());
  WASH_PETSC(
      MatCreateAIJ(cloths_.comm(), rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, 1, nullptr, 0, nullptr, own.put()));
  for (std::size_t m = 0; m < rates_.size(); ++m)
    for (PetscInt c = 0; c < Dim; ++c) {
      const PetscInt row = cloths_.number_of(m) * Dim + c;
      WASH_PETSC(MatSetValue(own, row, row, factor * rates_[m], INSERT_VALUES));
    }
  WASH_PETSC(MatAssemblyBegin(own, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(own, MAT_FINAL_ASSEMBLY));
  mobility.add(std::move(own));
}

template class Seepage<2>;
template class Seepage<3>;

}  // namespace washfsi
