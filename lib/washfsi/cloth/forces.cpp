// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/forces.hpp"

#include <algorithm>
#include <limits>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
bool Forces<Dim>::have_friction() const {
  return std::any_of(forces_.begin(), forces_.end(), [](const auto& force) { return force->has_friction(); });
}

template <int Dim>
const MarkerForce<Dim>* Forces<Dim>::without_jacobian() const {
  for (const auto& force : forces_)
    if (force->dependence() == Dependence::places) return force.get();
  return nullptr;
}

template <int Dim>
void Forces<Dim>::begin_step(const StepStart<Dim>& start) {
  for (const auto& force : forces_) force->begin_step(start);
}

template <int Dim>
bool Forces<Dim>::is_of_places(const MarkerForce<Dim>& force) const {
  return force.dependence() == Dependence::potential || force.dependence() == Dependence::places;
}

template <int Dim>
template <class Select>
Points<Dim> Forces<Dim>::sum_of(const Select& select, const Points<Dim>& positions,
                                const Points<Dim>& velocities) const {
  Points<Dim> sum(cloths_.owned(), Point<Dim>::Zero());
  for (const auto& force : forces_)
    if (select(*force)) force->add_force(positions, velocities, sum);
  return sum;
}

template <int Dim>
Points<Dim> Forces<Dim>::of_places(const Points<Dim>& positions) const {
  const petsc::LogPart log("cloth_force");
  return sum_of([&](const auto& force) { return is_of_places(force); }, positions, {});
}

template <int Dim>
Points<Dim> Forces<Dim>::of_velocities(const Points<Dim>& positions, const Points<Dim>& velocities) const {
  const petsc::LogPart log("cloth_force");
  return sum_of([](const auto& force) { return force.dependence() == Dependence::velocities; }, positions, velocities);
}

template <int Dim>
Points<Dim> Forces<Dim>::constant() const {
  return sum_of([](const auto& force) { return force.dependence() == Dependence::none; }, {}, {});
}

template <int Dim>
Points<Dim> Forces<Dim>::all(const Points<Dim>& positions, const Points<Dim>& velocities) const {
  return of_places(positions) + of_velocities(positions, velocities) + constant();
}

template <int Dim>
template <class Select>
std::vector<double> Forces<Dim>::energies_of(const Select& select, const Points<Dim>& positions) const {
  std::vector<double> energies(cloths_.groups().size(), 0.0);
  for (const auto& force : forces_)
    if (select(*force)) force->add_energy(positions, energies);
  return ordered_sum(cloths_.comm(), energies);
}

template <int Dim>
std::vector<double> Forces<Dim>::energies(const Points<Dim>& positions) const {
  return energies_of([&](const auto& force) { return is_of_places(force); }, positions);
}

template <int Dim>
std::vector<double> Forces<Dim>::elastic_energies(const Points<Dim>& positions) const {
  return energies_of([](const auto& force) { return force.is_elastic(); }, positions);
}

template <int Dim>
double Forces<Dim>::round_off(const Points<Dim>& positions) const {
  std::vector<double> sizes(positions.size(), 0.0);
  for (const auto& force : forces_)
    if (is_of_places(*force)) force->add_cancelling_size(positions, sizes);
  double squares = 0;
  for (const double size : sizes) squares += size * size;
  return std::numeric_limits<double>::epsilon() * std::sqrt(ordered_sum(cloths_.comm(), squares));
}

template <int Dim>
Points<Dim> Forces<Dim>::stiffness_product(const Points<Dim>& positions, const Points<Dim>& direction) const {
  Points<Dim> rates(cloths_.owned(), Point<Dim>::Zero());
  for (const auto& force : forces_)
    if (is_of_places(*force)) force->add_force_rates(positions, direction, rates);
  for (auto& rate : rates) rate = -rate;
  return rates;
}

template <int Dim>
std::vector<long> Forces<Dim>::pattern() const {
  std::vector<long> pattern;
  for (const auto& force : forces_) pattern.push_back(force->pattern());
  return pattern;
}

template <int Dim>
bool Forces<Dim>::outgrow_pattern() const {
  return any_rank(comm(), std::ranges::any_of(forces_, [](const auto& force) { return force->outgrows_pattern(); }));
}

template <int Dim>
void Forces<Dim>::renew_pattern() {
  for (const auto& force : forces_) force->renew_pattern();
}

template <int Dim>
void Forces<Dim>::lay_out_stiffness(petsc::Matrix& matrix) {
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
void Forces<Dim>::set_stiffness(const Points<Dim>& positions, GeometricStiffness geometric, double factor,
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

template <int Dim>
bool Forces<Dim>::sharpen(const Points<Dim>& positions) {
  bool is_sharper = false;
  for (const auto& force : forces_) is_sharper = force->sharpen(positions) || is_sharper;
  return is_sharper;
}

template <int Dim>
std::vector<StiffnessBound> Forces<Dim>::bounds() const {
  std::vector<StiffnessBound> bounds(cloths_.owned());
  for (const auto& force : forces_) force->add_bound(bounds);
  return bounds;
}

template <int Dim>
bool Forces<Dim>::have_step_limit() const {
  return std::any_of(forces_.begin(), forces_.end(), [](const auto& force) { return force->has_step_limit(); });
}

template <int Dim>
double Forces<Dim>::step_limit(const Points<Dim>& from, const Points<Dim>& motion) {
  double part = 1;
  for (const auto& force : forces_)
    if (force->has_step_limit()) part = std::min(part, force->step_limit(from, motion));
  return part;
}

template <int Dim>
Points<Dim> Forces<Dim>::shortened(const Points<Dim>& from, Points<Dim> motion) {
  for (const auto& force : forces_)
    if (force->has_step_limit()) force->shorten(from, motion);
  return motion;
}

template class Forces<2>;
template class Forces<3>;

}  // namespace washfsi
