// SPDX-License-Identifier: BSD-3-Clause
//
// The fractional step of Brown, Cortez and Minion (2001), thesis (2.2-20, 2.2-21), with variable density:
//   1. explicit terms  b  = u^n + dt [ -(u.grad u) from n, n - 1 and n - 2 (`adams_bashforth.hpp`)
//                                      - (1/rho) grad p^(n-1/2) + (mu / 2 rho) lap u^n + (f - G)/rho ]
//   2. predict         u* - (mu dt / 2 rho) lap u* = b,    u* = u_b on the boundary, u* = u_solid in solids
//      a prescribed bulk velocity corrects G and u* (`driving.hpp`)
//   3. project         div( (1/rho) grad q ) = div u* / dt,    u^(n+1) = u* - (dt/rho) grad q
//                      p^(n+1/2) = p^(n-1/2) + q - (mu/2) div u*
//   3b. add_force      (couplings, bodies' walls) u += (dt/rho) H f, `project_again`: p += q without the viscous term
//   4. finish          n becomes n + 1
// The first step takes (u.grad u)^0 alone (forward Euler), the second two of them. Where the viscosity varies, div tau
// (`viscous_stress.hpp`) takes the place of mu lap u, and mu div u* that of (mu/2) div u*.
#pragma once

#include <functional>
#include <string>

#include "washfsi/fluid/force_field.hpp"
#include "washfsi/fluid/momentum.hpp"
#include "washfsi/fluid/options.hpp"
#include "washfsi/fluid/pressure.hpp"
#include "washfsi/fluid/projection.hpp"
#include "washfsi/support/clock.hpp"
#include "washfsi/support/state_list.hpp"

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
  const ForceField* further_force = nullptr;  ///< acts beside `force` from the start of the step, if there is one
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
class FractionalStep : public Projection {
 public:
  /// Starts with water at rest. Collective.
  FractionalStep(const Grid<Dim>& grid, Boundary<Dim>& boundary, const FluidOptions<Dim>& options);
  /// Sets the velocity at the start. Collective.
  void start(const VelocityAt<Dim>& velocity);

  /// Takes a whole step without direct forcing: predict, project, finish. Collective. Errors: DivergedError.
  void advance(const TimeStep& step, const StepFields<Dim>& fields);

  /// Phases 1 and 2: u* from u^n. Collective.
  void predict(const TimeStep& step, const StepFields<Dim>& fields);
  /// Phase 3: makes the intermediate velocity divergence free and updates the pressure. Collective.
  void project();
  /// Phase 3b: adds a further force density (faces) to the projected velocity; `project_again` follows. The part
  /// (1 - H) f acts on solids: it is subtracted from the constraint force. Collective.
  void add_force(Vec force);
  void project_again() override;
  void project_increment(Vec increment) override;
  /// Saves the pressure, and restores it after a trial, for schemes that try a step several times.
  void keep_pressure();
  void restore_pressure();
  /// Phase 4: the intermediate velocity becomes u^(n+1). Collective.
  void finish();

  Vec velocity() const { return velocity_; }                ///< u^n [m/s]
  Vec velocity_before() const { return velocity_before_; }  ///< u^(n-1); u^n before the first step
  Vec next_velocity() const { return intermediate_; }       ///< u* or u^(n+1) before `finish` [m/s]
  Vec pressure() const { return pressure_; }                ///< p^(n-1/2) [Pa]
  /// Length of the last step [s]; 0 before the first, which advects by forward Euler: u^(n-1) is not known then.
  double last_step() const { return dt_before_; }
  /// Whether the velocity is made free of divergence.
  bool projects() const { return projects_; }
  Advection scheme_of_advection() const { return advection_scheme_; }
  /// Whether advection departs from central; and the power that it then dissipated in the last step, which central
  /// advection does not [W; W/m in the plane].
  bool departs_from_central() const { return advection_scheme_ != Advection::central || limits_at_edges_; }
  double numerical_dissipation() const { return numerical_dissipation_; }

  /// Constraint force density of solids on the water in the last `predict` [N/m3]; zero in fluid.
  Vec constraint_force() const { return constraint_force_; }

  /// Registers the state that is carried from step to step.
  void register_state(StateList& state);

  /// The driving of the water along periodic axes.
  const Driving<Dim>& driving() const { return driving_; }

  const SolverCounts& counts() const { return counts_; }

 private:
  void add_further_forces();
  void find_constraint_force();
  void explicit_terms();
  template <class Form>
  void sum_explicit_terms(const Form& viscosity, Vec local_u, Vec local_p);
  void advect(Vec local_velocity, Vec density);
  template <class Flux>
  void replace_advection(const Box<Dim>& where, const ConstFaceView<Dim>& u, const ConstFaceView<Dim>& rho,
                         const Flux& flux);
  double largest_speed() const;
  void solve_pressure(Vec phi);
  void find_minus_divergence(Vec local_velocity);
  void add_viscous_pressure();

  const Grid<Dim>& grid_;
  Boundary<Dim>& boundary_;  ///< its open sides take part in the step
  double pressure_tolerance_;
  bool projects_, limits_at_edges_;
  Advection advection_scheme_;
  double advection_bend_;  ///< `bend` of `adams_bashforth`
  DM flow_dm_;             ///< face DM with the ghosts that advection and open sides need
  MomentumSolver<Dim> momentum_;
  PressureSolver<Dim> poisson_;
  Driving<Dim> driving_;

  petsc::Vector velocity_, velocity_before_;    ///< u^n, u^(n-1)
  petsc::Vector intermediate_;                  ///< u*, then u^(n+1)
  petsc::Vector advection_, advection_before_;  ///< (u.grad u)^n, (u.grad u)^(n-1)
  petsc::Vector advection_earlier_;             ///< (u.grad u)^(n-2)
  petsc::Vector rhs_;                           ///< b of the last `predict`
  petsc::Vector force_;                         ///< all force density of the current step, the further one included
  petsc::Vector constraint_force_;              ///< constraint force density; null before there is any
  petsc::Vector pressure_;                      ///< p^(n-1/2)
  petsc::Vector phi_;                           ///< dt q / rho_f of the last projection: the next one's guess
  petsc::Vector minus_divergence_;
  petsc::Vector phi_of_force_, kept_pressure_;  ///< for further forces and for `keep_pressure`; created when first used
  TimeStep step_;                               ///< current step
  StepFields<Dim> fields_;                      ///< fields of the current step
  double dt_before_ = 0, dt_earlier_ = 0;       ///< lengths of the last step and the one before it [s]; 0 if none
  double numerical_dissipation_ = 0;
  SolverCounts counts_;
};

extern template class FractionalStep<2>;
extern template class FractionalStep<3>;

}  // namespace washfsi
