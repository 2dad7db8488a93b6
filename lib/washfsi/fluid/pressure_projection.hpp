// SPDX-License-Identifier: BSD-3-Clause
//
// The projection of a step, and the pressure that it updates:
//   div( (1/rho) grad q ) = div u* / dt,    u^(n+1) = u* - (dt/rho) grad q
//   p^(n+1/2) = p^(n-1/2) + q - (mu/2) div u*
// and again after a further force, then with p += q alone. Where the viscosity varies, mu div u* takes the place of
// (mu/2) div u*.
#pragma once

#include "washfsi/fluid/liquid.hpp"
#include "washfsi/fluid/options.hpp"
#include "washfsi/fluid/pressure.hpp"
#include "washfsi/fluid/projection.hpp"
#include "washfsi/grid/constraint.hpp"
#include "washfsi/support/clock.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

template <int Dim>
class PressureProjection : public Projection {
 public:
  /// Collective.
  PressureProjection(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const FluidOptions<Dim>& options);

  /// Whether velocities are made free of divergence at all.
  bool is_on() const { return is_on_; }

  /// Begins a step, which may be a trial of several: from now on this is the velocity on faces that is projected, in
  /// place; it stays alive until the next call. Collective.
  void begin(const TimeStep& step, double dt_before, const LiquidFields& liquid, const Constraint<Dim>& constraint,
             Vec velocity);
  /// Makes the step's velocity divergence free and updates the pressure. Collective. Errors: DivergedError.
  void project();
  void project_again() override;
  void project_increment(Vec increment) override;

  Vec pressure() const { return pressure_; }  ///< p^(n-1/2), of the last step after `project` [Pa]
  /// Saves the pressure, and restores it after a trial, for schemes that try a step several times.
  void save_pressure();
  void restore_pressure();

  /// Iterations of the pressure solver so far.
  double iterations() const { return iterations_; }
  /// Registers the state that is carried from step to step.
  void register_state(StateList& state);

 private:
  void solve(Vec phi);
  void find_minus_divergence(Vec local_velocity);
  void add_viscous_pressure();
  double largest_speed() const;

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  double tolerance_;
  bool is_on_;
  PressureSolver<Dim> poisson_;
  petsc::Vector pressure_;
  petsc::Vector phi_;  ///< phi, q~ of the theory (`pressure.hpp`), of the last `project`: the next guess
  petsc::Vector minus_divergence_;
  petsc::Vector phi_of_force_, saved_pressure_;  ///< created when first used
  TimeStep step_;
  Viscosity viscosity_;
  Vec velocity_ = nullptr;
  double iterations_ = 0;
};

extern template class PressureProjection<2>;
extern template class PressureProjection<3>;

}  // namespace washfsi
