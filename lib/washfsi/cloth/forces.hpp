// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/cloth/marker_force.hpp"
#include "washfsi/cloth/stiffness_rows.hpp"

namespace washfsi {

/// All forces on the markers, as one. Sums are taken in the order in which the forces were added. Arrays hold this
/// rank's markers; forces in [N; per unit depth in the plane]. All members are collective unless said.
template <int Dim>
class Forces {
 public:
  /// The cloths must outlive it.
  explicit Forces(const Cloths<Dim>& cloths) : cloths_(cloths) {}

  MPI_Comm comm() const { return cloths_.comm(); }
  /// No communication.
  void add(std::unique_ptr<MarkerForce<Dim>> force) { forces_.push_back(std::move(force)); }
  const std::vector<std::unique_ptr<MarkerForce<Dim>>>& list() const { return forces_; }
  /// The first force without the Jacobian that an implicit treatment needs; null if there is none. No communication.
  const MarkerForce<Dim>* without_jacobian() const;

  void begin_step(const StepStart<Dim>& start);

  /// The forces that depend on places alone.
  Points<Dim> of_places(const Points<Dim>& positions) const;
  /// Those that depend on velocities too.
  Points<Dim> of_velocities(const Points<Dim>& positions, const Points<Dim>& velocities) const;
  /// Those that are constant over a step.
  Points<Dim> constant() const;
  Points<Dim> all(const Points<Dim>& positions, const Points<Dim>& velocities) const;

  /// Energy of each group of cloths [J; per unit depth in the plane]: of all forces of places; of what is stored in the
  /// cloth alone.
  std::vector<double> energies(const Points<Dim>& positions) const;
  std::vector<double> elastic_energies(const Points<Dim>& positions) const;
  /// 2-norm over all markers of the round-off that `of_places` may have.
  double round_off(const Points<Dim>& positions) const;

  /// K d, with K minus the Jacobian of `of_places`.
  Points<Dim> stiffness_product(const Points<Dim>& positions, const Points<Dim>& direction) const;
  /// Makes a matrix with a row for each coordinate of each marker and the places of K's entries; to be done anew when
  /// `pattern` has changed.
  void lay_out_stiffness(petsc::Matrix& matrix);
  std::vector<long> pattern() const;
  /// Whether any rank has left out blocks of K that have no places; and makes a pattern with these.
  bool outgrow_pattern() const;
  void renew_pattern();
  /// Sets a matrix, laid out for this pattern, to factor times K.
  void set_stiffness(const Points<Dim>& positions, GeometricStiffness geometric, double factor, Mat matrix) const;

  /// Whether any force is of friction.
  bool have_friction() const;

  /// Whether markers must not go anywhere; the part of a motion from 0 to 1 that all can make at once; and that motion,
  /// shortened for those markers alone that cannot make it.
  bool have_step_limit() const;
  double step_limit(const Points<Dim>& from, const Points<Dim>& motion);
  Points<Dim> shortened(const Points<Dim>& from, Points<Dim> motion);

  /// What bounds the explicit step, for each marker.
  std::vector<StiffnessBound> bounds() const;

 private:
  bool is_of_places(const MarkerForce<Dim>& force) const;
  template <class Select>
  Points<Dim> sum_of(const Select& select, const Points<Dim>& positions, const Points<Dim>& velocities) const;
  template <class Select>
  std::vector<double> energies_of(const Select& select, const Points<Dim>& positions) const;

  const Cloths<Dim>& cloths_;
  std::vector<std::unique_ptr<MarkerForce<Dim>>> forces_;
  StiffnessRows<Dim> rows_;  ///< of the pattern that was laid out last
};

extern template class Forces<2>;
extern template class Forces<3>;

}  // namespace washfsi
