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
  /// Adds a force. No communication.
  void add(std::unique_ptr<MarkerForce<Dim>> force) { forces_.push_back(std::move(force)); }
  const std::vector<std::unique_ptr<MarkerForce<Dim>>>& list() const { return forces_; }
  /// The first force without the Jacobian that an implicit treatment needs; null if there is none. No communication.
  const MarkerForce<Dim>* without_jacobian() const;

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

  /// K d, with K minus the Jacobian of `of_places`.
  Points<Dim> stiffness_product(const Points<Dim>& positions, const Points<Dim>& direction) const;
  /// Creates a matrix with a row for each coordinate of each marker and the nonzero pattern of K; call it again when
  /// `pattern` has changed.
  void lay_out_stiffness(petsc::Matrix& matrix);
  std::vector<long> pattern() const;
  /// Whether any rank has left out blocks of K that are not in the pattern; and renews the pattern with these.
  bool outgrow_pattern() const;
  void renew_pattern();
  /// Sets a matrix, laid out for this pattern, to factor times K.
  void set_stiffness(const Points<Dim>& positions, GeometricStiffness geometric, double factor, Mat matrix) const;

  /// Whether any force is of friction.
  bool have_friction() const;

  /// Whether any force has a step limit; the share of a motion, from 0 to 1, that is within the limit for all markers;
  /// and the motion shortened only for those markers that exceed it.
  bool have_step_limit() const;
  double step_limit(const Points<Dim>& from, const Points<Dim>& motion);
  Points<Dim> shortened(const Points<Dim>& from, Points<Dim> motion);
  /// Sharpens the forces at the solution of a step; returns whether it has to be solved again.
  bool sharpen(const Points<Dim>& positions);

  /// The stiffness and damping of each marker, which bound the explicit step.
  std::vector<StiffnessBound> bounds() const;

 private:
  bool is_of_places(const MarkerForce<Dim>& force) const;
  template <class Select>
  Points<Dim> sum_of(const Select& select, const Points<Dim>& positions, const Points<Dim>& velocities) const;
  template <class Select>
  std::vector<double> energies_of(const Select& select, const Points<Dim>& positions) const;

  const Cloths<Dim>& cloths_;
  std::vector<std::unique_ptr<MarkerForce<Dim>>> forces_;
  StiffnessRows<Dim> rows_;  ///< rows of the pattern that was laid out last
};

extern template class Forces<2>;
extern template class Forces<3>;

}  // namespace washfsi
