// SPDX-License-Identifier: BSD-3-Clause
//
// The advection of momentum, u.grad u in flux form (`advection.hpp`), at the starts of the present step and the two
// before it. A step takes their extrapolation to its middle (`adams_bashforth.hpp`); the first step has the present one
// alone (forward Euler), the second two of them.
#pragma once

#include "washfsi/fluid/adams_bashforth.hpp"
#include "washfsi/fluid/options.hpp"
#include "washfsi/grid/boundary.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// The fields at the start of a step that advection reads.
struct AdvectedFields {
  Vec local_velocity = nullptr;  ///< with the ghosts of `velocity_dm`, filled [m/s]
  Vec density = nullptr;         ///< on faces [kg/m3]
  Vec fluid_fraction = nullptr;  ///< on faces; null: 1. Water in solids dissipates nothing by its advection.
  Vec upwind_weight = nullptr;   ///< on faces, for advection that is limited at edges
};

template <int Dim>
class MomentumAdvection {
 public:
  /// Collective.
  MomentumAdvection(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const FluidOptions<Dim>& options);

  /// The face DM with the ghosts that advection and open sides need.
  DM velocity_dm() const { return velocity_dm_; }
  /// Whether what it carries is bounded by its neighbours everywhere.
  bool is_bounded() const { return scheme_ == Advection::upwind; }
  /// Whether it departs from central; and the power that it then dissipated in the last step, which central advection
  /// does not [W; W/m in the plane].
  bool departs_from_central() const { return scheme_ != Advection::central || limits_at_edges_; }
  double numerical_dissipation() const { return numerical_dissipation_; }
  /// Length of the last step [s]; 0 before the first.
  double last_step() const { return dt_before_; }

  /// Finds the term at the start of a step. May be repeated. Collective.
  void find(const AdvectedFields& fields);
  /// The weights of the three terms in a step of this length [s].
  AdvectionWeights weights(double dt) const { return adams_bashforth(bend_, dt, dt_before_, dt_earlier_); }
  Vec now() const { return now_; }          ///< (u.grad u)^n, on inner faces [m/s2]
  Vec before() const { return before_; }    ///< (u.grad u)^(n-1)
  Vec earlier() const { return earlier_; }  ///< (u.grad u)^(n-2)
  /// Ends a step of this length [s].
  void finish(double dt);

  /// Registers the terms and lengths of the previous steps.
  void register_state(StateList& state);

 private:
  template <class Flux>
  void replace(const Box<Dim>& where, const AdvectedFields& fields, const Flux& flux);

  const Grid<Dim>& grid_;
  Advection scheme_;
  bool limits_at_edges_;
  double bend_;  ///< `bend` of `adams_bashforth`
  DM velocity_dm_;
  petsc::Vector now_, before_, earlier_;
  double dt_before_ = 0, dt_earlier_ = 0;  ///< lengths of the last step and the one before it [s]; 0 if none
  double numerical_dissipation_ = 0;
};

extern template class MomentumAdvection<2>;
extern template class MomentumAdvection<3>;

}  // namespace washfsi
