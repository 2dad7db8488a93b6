// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/model.hpp"

namespace washfsi {

/// The longest explicit step [s] for the cloth as it lies. With the mobility per area D_A of a marker, the stiffest
/// oscillation of its sheet has the frequency omega, for a fibre in penalty contact
///   omega^2 = 4 D_A (K_e/ds^2 + 4 K_b/ds^4 + p_0/(2 d_0)),
/// and the damped explicit step needs dt^2 + 2 beta dt < (2/omega)^2. Without damping, bending and contact this is
/// dt < ds/sqrt(K_e D_A), about half of the longest stable step. Infinite without cloth. Needs `transfer.locate`.
/// Collective.
template <int Dim>
double cloth_step_bound(const Model<Dim>& model);

/// D_A: the velocity of each marker per unit time when all markers bear a unit force per undeformed area [m2/kg]. Needs
/// `transfer.locate`. Collective.
template <int Dim>
std::vector<double> mobility_per_area(const Model<Dim>& model);

/// The speeds that bodies will have, so that a step is short enough for a body that begins to move.
template <int Dim>
class BodySpeeds {
 public:
  /// Collective. The model must outlive it.
  explicit BodySpeeds(const Model<Dim>& model);
  /// Largest distance from a body's centre to its material within the box at the start [m].
  double arm(std::size_t body) const { return arms_[body]; }
  /// Returns dt, or a shorter step after which no body's CFL number is much above `courant`.
  double longest_step(double time, double dt, double courant) const;

 private:
  double at(double time) const;

  const Model<Dim>& model_;
  std::vector<double> arms_;
};

/// The time in which the largest speed that boundary, bodies or the present flow prescribe crosses a cell [s]: the step
/// of CFL number 1; infinite at rest. Collective.
template <int Dim>
double flow_time(const Model<Dim>& model, const BodySpeeds<Dim>& bodies);

extern template class BodySpeeds<2>;
extern template class BodySpeeds<3>;

}  // namespace washfsi
