// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/forces.hpp"

#include <algorithm>
#include <limits>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
void Forces<Dim>::begin_step(const StepStart<Dim>& start) {
  for (const auto& force : forces_) force->begin_step(start);
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
  return sum_of([](const auto& force) { return force.kind().dependence == Dependence::velocities; }, positions,
                velocities);
}

template <int Dim>
Points<Dim> Forces<Dim>::constant() const {
  return sum_of([](const auto& force) { return force.kind().dependence == Dependence::none; }, {}, {});
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
  return energies_of([](const auto& force) { return force.kind().is_elastic; }, positions);
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
bool Forces<Dim>::sharpen(const Points<Dim>& positions) {
  bool is_sharper = false;
  for (const auto& force : forces_) is_sharper = force->sharpen(positions) || is_sharper;
  return is_sharper;
}

template <int Dim>
bool Forces<Dim>::have_step_limit() const {
  return std::any_of(forces_.begin(), forces_.end(), [](const auto& force) { return force->kind().has_step_limit; });
}

template <int Dim>
double Forces<Dim>::step_limit(const Points<Dim>& from, const Points<Dim>& motion) {
  double part = 1;
  for (const auto& force : forces_)
    if (force->kind().has_step_limit) part = std::min(part, force->step_limit(from, motion));
  return part;
}

template <int Dim>
Points<Dim> Forces<Dim>::shortened(const Points<Dim>& from, Points<Dim> motion) {
  for (const auto& force : forces_)
    if (force->kind().has_step_limit) force->shorten(from, motion);
  return motion;
}

template class Forces<2>;
template class Forces<3>;

}  // namespace washfsi
