// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/force_stiffness.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
Points<Dim> ForceStiffness<Dim>::product(const Points<Dim>& positions, const Points<Dim>& direction) const {
  Points<Dim> rates(cloths_.owned(), Point<Dim>::Zero());
  for (const auto& force : forces_)
    if (is_of_places(*force)) force->add_force_rates(positions, direction, rates);
  for (auto& rate : rates) rate = -rate;
  return rates;
}

template <int Dim>
std::vector<long> ForceStiffness<Dim>::pattern() const {
  std::vector<long> pattern;
  for (const auto& force : forces_) pattern.push_back(force->pattern());
  return pattern;
}

template <int Dim>
bool ForceStiffness<Dim>::outgrow_pattern() const {
  return any_rank(cloths_.comm(),
                  std::ranges::any_of(forces_, [](const auto& force) { return force->outgrows_pattern(); }));
}

template <int Dim>
void ForceStiffness<Dim>::renew_pattern() {
  for (const auto& force : forces_) force->renew_pattern();
}

template <int Dim>
void ForceStiffness<Dim>::lay_out(petsc::Matrix& matrix) {
  std::vector<typename StiffnessRows<Dim>::Place> places;
  const Points<Dim> anywhere(cloths_.owned(), Point<Dim>::Zero());
  const auto list = [&](PetscInt row, PetscInt column, const StiffnessBlock<Dim>&) { places.push_back({row, column}); };
  for (const auto& force : forces_)
    if (is_of_places(*force)) force->visit_stiffness(anywhere, GeometricStiffness::all, list);
  rows_ = StiffnessRows<Dim>(cloths_.begin(), cloths_.owned(), places);
  rows_.create(cloths_.comm(), matrix);
  WASH_PETSC(MatSetOption(matrix, MAT_SYMMETRIC, PETSC_TRUE));
}

template <int Dim>
void ForceStiffness<Dim>::set(const Points<Dim>& positions, GeometricStiffness geometric, double factor,
                              Mat matrix) const {
  std::vector<StiffnessBlock<Dim>> blocks(rows_.count(), StiffnessBlock<Dim>::Zero());
  std::size_t visited = 0;
  const auto add = [&](PetscInt, PetscInt, const StiffnessBlock<Dim>& block) {
    blocks[rows_.number_of(visited++)] += factor * block;
  };
  for (const auto& force : forces_)
    if (is_of_places(*force)) {
      force->linearise(positions);
      force->visit_stiffness(positions, geometric, add);
    }
  rows_.set(blocks, matrix);
}

template class ForceStiffness<2>;
template class ForceStiffness<3>;

}  // namespace washfsi
