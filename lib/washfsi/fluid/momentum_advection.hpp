// SPDX-License-Identifier: BSD-3-Clause
//
// The advection of momentum, u.grad u in flux form (`advection.hpp`), at the starts of the present step and the two
// before it. A step takes their extrapolation to its middle (`adams_bashforth.hpp`); the first step has the present one
// alone (forward Euler), the second two of them.
#pragma once

#include "washfsi/fluid/adams_bashforth.hpp"
#include "washfsi/fluid/advection_scheme.hpp"
#include "washfsi/fluid/options.hpp"
#include "washfsi/grid/boundary.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

template <int Dim>
class MomentumAdvection {
 public:
  /// Collective.
  MomentumAdvection(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const FluidOptions<Dim>& options);

  /// The face DM with the ghosts that advection and open sides need.
  DM velocity_dm() const { return velocity_dm_; }
  const AdvectionScheme<Dim>& scheme() const { return *scheme_; }
  /// The power that the scheme dissipated in the last step and central advection does not [W; W/m in two dimensions].
  double numerical_dissipation() const { return numerical_dissipation_; }
  /// Length of the last step [s]; 0 before the first.
  double last_step() const { return dt_before_; }

  /// Finds the term at the start of a step. May be repeated. Collective.
  void find(const AdvectedFields& fields) { numerical_dissipation_ = scheme_->find(fields, now_); }
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
  const Grid<Dim>& grid_;
  std::unique_ptr<AdvectionScheme<Dim>> scheme_;
  double bend_;  ///< `bend` of `adams_bashforth`
  DM velocity_dm_;
  petsc::Vector now_, before_, earlier_;
  double dt_before_ = 0, dt_earlier_ = 0;  ///< lengths of the last step and the one before it [s]; 0 if none
  double numerical_dissipation_ = 0;
};

extern template class MomentumAdvection<2>;
extern template class MomentumAdvection<3>;

}  // namespace washfsi
