// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/model.hpp"

namespace washfsi {

/// The longest explicit step [s] for the cloth as it lies: with the mobility m_k of each marker, the stiffest
/// oscillation of its sheet has the frequency w, for a fibre w^2 = 4 m_k (Ke/ds^2 + 4 Kb/ds^4), and the damped explicit
/// step needs dt^2 + 2 beta dt < (2/w)^2. Without damping and bending this is dt < ds/sqrt(Ke m_k), which is about
/// twice on the safe side. Infinite without cloth. Needs `transfer.locate`. Collective.
template <int Dim>
double cloth_step_bound(const Model<Dim>& model);

/// Velocity of each marker per force on unit areas of all cloths and time [m2/kg]. Needs `transfer.locate`. Collective.
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
