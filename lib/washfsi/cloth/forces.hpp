// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <memory>

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/force_stiffness.hpp"

namespace washfsi {

/// All forces on the markers, as one. Sums are taken in the order in which the forces were added. Arrays hold this
/// rank's markers; forces in [N; per unit depth in the plane]. All members are collective unless said.
template <int Dim>
class Forces {
 public:
  /// The cloths must outlive it.
  explicit Forces(const Cloths<Dim>& cloths) : cloths_(cloths), stiffness_(cloths, forces_) {}
  Forces(const Forces&) = delete;
  Forces& operator=(const Forces&) = delete;

  MPI_Comm comm() const { return cloths_.comm(); }
  /// Adds a force. No communication.
  void add(std::unique_ptr<MarkerForce<Dim>> force) { forces_.push_back(std::move(force)); }
  const std::vector<std::unique_ptr<MarkerForce<Dim>>>& list() const { return forces_; }

  void begin_step(const StepStart<Dim>& start);

  /// The sum of the forces that depend on places alone.
  Points<Dim> of_places(const Points<Dim>& positions) const;
  /// The sum of the forces that depend on velocities too.
  Points<Dim> of_velocities(const Points<Dim>& positions, const Points<Dim>& velocities) const;
  /// The sum of the forces that are constant over a step.
  Points<Dim> constant() const;
  Points<Dim> all(const Points<Dim>& positions, const Points<Dim>& velocities) const;

  /// Energy of each group of cloths [J; per unit depth in the plane]: of all forces of places; of what is stored in the
  /// cloth alone.
  std::vector<double> energies(const Points<Dim>& positions) const;
  std::vector<double> elastic_energies(const Points<Dim>& positions) const;
  /// 2-norm over all markers of the round-off that `of_places` may have.
  double round_off(const Points<Dim>& positions) const;

  /// K, minus the Jacobian of `of_places`.
  ForceStiffness<Dim>& stiffness() { return stiffness_; }
  const ForceStiffness<Dim>& stiffness() const { return stiffness_; }

  /// Whether any force has a step limit; the share of a motion, from 0 to 1, that is within the limit for all markers;
  /// and the motion shortened only for those markers that exceed it.
  bool have_step_limit() const;
  double step_limit(const Points<Dim>& from, const Points<Dim>& motion);
  Points<Dim> shortened(const Points<Dim>& from, Points<Dim> motion);
  /// Sharpens the forces at the solution of a step; returns whether it has to be solved again.
  bool sharpen(const Points<Dim>& positions);

 private:
  template <class Select>
  Points<Dim> sum_of(const Select& select, const Points<Dim>& positions, const Points<Dim>& velocities) const;
  template <class Select>
  std::vector<double> energies_of(const Select& select, const Points<Dim>& positions) const;

  const Cloths<Dim>& cloths_;
  std::vector<std::unique_ptr<MarkerForce<Dim>>> forces_;
  ForceStiffness<Dim> stiffness_;
};

/// The first force without the Jacobian that an implicit treatment needs; null if there is none.
template <int Dim>
const MarkerForce<Dim>* without_jacobian(const Forces<Dim>& forces) {
  for (const auto& force : forces.list())
    if (force->kind().dependence == Dependence::places) return force.get();
  return nullptr;
}

/// Whether any force is of friction.
template <int Dim>
bool have_friction(const Forces<Dim>& forces) {
  return std::ranges::any_of(forces.list(), [](const auto& force) { return force->kind().has_friction; });
}

extern template class Forces<2>;
extern template class Forces<3>;

}  // namespace washfsi
