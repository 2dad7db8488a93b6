// SPDX-License-Identifier: BSD-3-Clause
//
// The fractional step of Brown, Cortez and Minion (2001), thesis (2.2-20, 2.2-21), with variable density:
//   1. explicit terms  u_e = u^n + dt [ -C* - (1/rho) grad p^(n-1/2) + (mu / 2 rho) lap u^n + (f - G)/rho ],
//                      with C* the advection u.grad u extrapolated from n, n - 1 and n - 2 (`adams_bashforth.hpp`)
//   2. predict         u* - (mu dt / 2 rho) lap u* = u_e,    with u* as prescribed on the boundary at t^(n+1), and
//                      u* = u_solid in solids; a prescribed bulk velocity corrects G and u* (`driving.hpp`)
//   3. project         div( (1/rho) grad q ) = div u* / dt,    u^(n+1) = u* - (dt/rho) grad q
//                      p^(n+1/2) = p^(n-1/2) + q - (mu/2) div u*
//   3b. add_force      (couplings, walls of bodies) u += (dt/rho) H f; then `project_again`, with p += q, without the
//                      viscous term
//   4. finish          n becomes n + 1
// The first step takes the advection term C^0 alone (forward Euler), the second step takes two terms. Where the
// viscosity varies, div tau (`viscous_stress.hpp`) takes the place of mu lap u, and mu div u* that of (mu/2) div u*.
#pragma once

#include <functional>

#include "washfsi/fluid/force_field.hpp"
#include "washfsi/fluid/momentum.hpp"
#include "washfsi/fluid/momentum_advection.hpp"
#include "washfsi/fluid/pressure_projection.hpp"

namespace washfsi {

/// Iterations spent so far.
struct SolverCounts {
  double momentum = 0, pressure = 0;
};

/// The fields that a step is given: the liquid, the force density on faces [N/m3] and the solids.
template <int Dim>
struct StepFields {
  LiquidFields liquid;
  Vec force = nullptr;
  Constraint<Dim> constraint;
  std::vector<const ForceField*> force_fields = {};  ///< act beside `force` from the start of the step; none is null
  /// The weight of upwind advection on faces with `limits_at_edges`: from 1 beside edges and thin parts to 0 beyond the
  /// kernels of their markers.
  Vec upwind_weight = nullptr;
  /// The share of each face that the mean pressure gradient drives; bodies take its force on the rest (`driving.hpp`).
  /// Null if it drives all.
  Vec driven_share = nullptr;
};

/// A function that gives a velocity's component c at a place [m/s].
template <int Dim>
using VelocityAt = std::function<double(const Point<Dim>& place, int c)>;

template <int Dim>
class FractionalStep {
 public:
  /// Starts with water at rest. Collective.
  FractionalStep(const Grid<Dim>& grid, Boundary<Dim>& boundary, const FluidOptions<Dim>& options);
  /// Sets the velocity at the start. Collective.
  void start(const VelocityAt<Dim>& velocity);

  /// Phases 1 and 2: u* from u^n. Collective.
  void predict(const TimeStep& step, const StepFields<Dim>& fields);
  /// Phases 3 and 3b act on the intermediate velocity and the pressure.
  PressureProjection<Dim>& projection() { return projection_; }
  const PressureProjection<Dim>& projection() const { return projection_; }
  /// Phase 3b: adds a further force density (faces) to the projected velocity; `project_again` follows. The part
  /// (1 - H) f acts on solids: it is subtracted from the constraint force. Collective.
  void add_force(Vec force);
  /// Phase 4: the intermediate velocity becomes u^(n+1). Collective.
  void finish();

  Vec velocity() const { return velocity_; }                   ///< u^n [m/s]
  Vec velocity_before() const { return velocity_before_; }     ///< u^(n-1); u^n before the first step
  Vec intermediate_velocity() const { return intermediate_; }  ///< u* or u^(n+1) before `finish` [m/s]
  /// Length of the last step [s]; 0 before the first: u^(n-1) is not known then.
  double last_step() const { return advection_.last_step(); }
  const MomentumAdvection<Dim>& advection() const { return advection_; }
  /// Constraint force density of solids on the water in the last `predict` [N/m3]; zero in fluid.
  Vec constraint_force() const { return constraint_force_; }
  const Driving<Dim>& driving() const { return driving_; }  ///< driving of the water along periodic axes
  SolverCounts counts() const { return {momentum_.iterations(), projection_.iterations()}; }

  /// Registers the state that is carried from step to step.
  void register_state(StateList& state);

 private:
  void add_further_forces();
  void explicit_terms();
  template <class Form>
  void sum_explicit_terms(const Form& viscosity, Vec local_u, Vec local_p);
  void solve_momentum();

  const Grid<Dim>& grid_;
  Boundary<Dim>& boundary_;  ///< its open sides take part in the step
  MomentumAdvection<Dim> advection_;
  MomentumSolver<Dim> momentum_;
  PressureProjection<Dim> projection_;
  Driving<Dim> driving_;

  petsc::Vector velocity_, velocity_before_;  ///< u^n, u^(n-1)
  petsc::Vector intermediate_;                ///< u*, then u^(n+1)
  petsc::Vector rhs_;                         ///< u_e of the last `predict`
  petsc::Vector force_;                       ///< all force density of the current step, the further one included
  petsc::Vector constraint_force_;            ///< constraint force density; null before there is any
  TimeStep step_;                             ///< current step
  StepFields<Dim> fields_;                    ///< fields of the current step
};

extern template class FractionalStep<2>;
extern template class FractionalStep<3>;

}  // namespace washfsi
