// SPDX-License-Identifier: BSD-3-Clause
//
// The fractional step of Brown, Cortez and Minion (2001), thesis (2.2-20, 2.2-21), with variable density:
//   1. explicit terms  b  = u^n + dt [ -(u.grad u) from n, n - 1 and n - 2 (`adams_bashforth.hpp`)
//                                      - (1/rho) grad p^(n-1/2) + (mu / 2 rho) lap u^n + (f - G)/rho ]
//   2. predict         u* - (mu dt / 2 rho) lap u* = b,    u* = u_b on the boundary, u* = u_solid in solids
//      a bulk velocity that is kept corrects G and u* (`driving.hpp`)
//   3. project         div( (1/rho) grad q ) = div u* / dt,    u^(n+1) = u* - (dt/rho) grad q
//                      p^(n+1/2) = p^(n-1/2) + q - (mu/2) div u*
//   3b. add_force      (couplings only) u += (dt/rho) H f, projected again: p += q without the viscous term
//      walls that hold the water by forces add those of the step before in 1, mend them once before the last
//      projection, of 3 or 3b, and again after it if the water slips
//   4. finish          n becomes n + 1
// The first step takes (u.grad u)^0 alone (forward Euler), the second two of them. Where the viscosity varies, div tau
// (`viscous_stress.hpp`) takes the place of mu lap u, and mu div u* that of (mu/2) div u*.
#pragma once

#include <functional>
#include <string>

#include "washfsi/fluid/momentum.hpp"
#include "washfsi/fluid/options.hpp"
#include "washfsi/fluid/pressure.hpp"
#include "washfsi/fluid/wall_forces.hpp"
#include "washfsi/support/clock.hpp"

namespace washfsi {

/// Iterations spent so far.
struct SolverCounts {
  double momentum = 0, pressure = 0;
};

/// What a step is given, as fields: the liquid, the force density on faces [N/m3] and the solids.
template <int Dim>
struct StepFields {
  LiquidFields liquid;
  Vec force = nullptr;
  Constraint<Dim> constraint;
  WallForces* walls = nullptr;  ///< what holds the water by forces, if anything does
  /// On faces, with `limits_at_edges`: how near they are to edges and thin parts, from 1 to 0 beyond the reach of their
  /// forces.
  Vec nearness = nullptr;
  /// On faces: the share that the gradient of the mean pressure drives, the rest of which the constraint holds
  /// (`driving.hpp`); null where it drives all.
  Vec driven_share = nullptr;
};

/// A velocity's component c at a place [m/s].
template <int Dim>
using VelocityAt = std::function<double(const Point<Dim>& place, int c)>;

template <int Dim>
class FractionalStep {
 public:
  /// The water rests. Collective.
  FractionalStep(const Grid<Dim>& grid, Boundary<Dim>& boundary, const FluidOptions<Dim>& options);
  /// Sets the velocity at the start. Collective.
  void start(const VelocityAt<Dim>& velocity);

  /// One whole step: predict, push walls, project, hold walls, finish. Collective. Errors: DivergedError.
  void advance(const TimeStep& step, const StepFields<Dim>& fields);

  /// Phases 1 and 2: u* from u^n. Collective.
  void predict(const TimeStep& step, const StepFields<Dim>& fields);
  /// Phase 3: makes the intermediate velocity divergence free and updates the pressure. Collective.
  void project();
  /// Phase 3b: adds a further force density (faces) to the projected velocity, pushes walls, and projects it again.
  /// What falls on solids is kept by them. Collective.
  void add_force(Vec force);
  /// Before a last projection: takes most of the slip away from walls that hold the water by forces. Collective.
  void push_walls(double relaxation = 1);
  /// After it: takes away what slip is left beyond the tolerance, with further projections. Collective.
  void hold_walls();
  /// For schemes that try a step several times: keeps the pressure, and takes the kept one back after a trial.
  void keep_pressure();
  void restore_pressure();
  /// Phase 4: the intermediate velocity becomes u^(n+1). Collective.
  void finish();

  Vec velocity() const { return velocity_; }                ///< u^n [m/s]
  Vec velocity_before() const { return velocity_before_; }  ///< u^(n-1); u^n before the first step
  Vec next_velocity() const { return intermediate_; }       ///< u* or u^(n+1) before `finish` [m/s]
  Vec pressure() const { return pressure_; }                ///< p^(n-1/2) [Pa]
  /// Length of the last step [s]; 0 before the first, which advects by forward Euler: u^(n-1) is not known then.
  double last_step() const { return has_history_ ? dt_before_ : 0; }
  /// Length of the step before it [s]; 0 if there was none.
  double step_before_last() const { return dt_earlier_; }
  void set_last_steps(double last, double before) {
    dt_before_ = last;
    has_history_ = last > 0;
    dt_earlier_ = before;
  }
  /// Whether the velocity is made free of divergence.
  bool projects() const { return projects_; }
  Advection scheme_of_advection() const { return advection_scheme_; }
  /// Whether advection is other than central, and then the power that it took out of the flow in the last step beyond
  /// central advection, which takes none [W; W/m in the plane].
  bool departs_from_central() const { return advection_scheme_ != Advection::central || limits_at_edges_; }
  double numerical_dissipation() const { return numerical_dissipation_; }

  /// Force density [N/m3] by which solids held the water in the last `predict`; zero in fluid.
  Vec constraint_force() const { return constraint_force_; }

  /// All vectors that a restart needs, with their names: the face fields, then the cell fields.
  std::vector<std::pair<std::string, Vec>> face_state() const;
  std::vector<std::pair<std::string, Vec>> cell_state() const;

  /// What drives the water along periodic axes.
  const Driving<Dim>& driving() const { return driving_; }
  Driving<Dim>& driving() { return driving_; }

  const SolverCounts& counts() const { return counts_; }
  void set_counts(const SolverCounts& counts) { counts_ = counts; }

 private:
  void add_held_forces();
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
  void project_again();
  void find_divergence(Vec local_velocity);
  void add_viscous_pressure();
  void free_of_divergence(Vec increment);

  const Grid<Dim>& grid_;
  Boundary<Dim>& boundary_;  ///< its open sides take part in the step
  double density_, pressure_tolerance_;
  bool projects_, limits_at_edges_;
  Advection advection_scheme_;
  double advection_bend_;  ///< of `adams_bashforth`
  DM flow_dm_;             ///< with the ghosts that advection and open sides need
  MomentumSolver<Dim> momentum_;
  PressureSolver<Dim> poisson_;
  Driving<Dim> driving_;

  petsc::Vector velocity_, velocity_before_;    ///< u^n, u^(n-1)
  petsc::Vector intermediate_;                  ///< u*, then u^(n+1)
  petsc::Vector advection_, advection_before_;  ///< (u.grad u)^n, (u.grad u)^(n-1)
  petsc::Vector advection_earlier_;             ///< (u.grad u)^(n-2)
  petsc::Vector rhs_;                           ///< b of the last `predict`
  petsc::Vector force_;                         ///< all of the step under way, with that of walls
  petsc::Vector constraint_force_;              ///< null before bodies have held anything
  petsc::Vector pressure_;                      ///< p^(n-1/2)
  petsc::Vector phi_;                           ///< dt q / rho_f of the last projection: the next one's guess
  petsc::Vector minus_divergence_;
  petsc::Vector phi_of_force_, kept_pressure_;  ///< for forces on top and `keep_pressure`; made when first used
  TimeStep step_;                               ///< under way
  StepFields<Dim> fields_;                      ///< of it
  double dt_before_ = 0, dt_earlier_ = 0;
  double numerical_dissipation_ = 0;
  bool has_history_ = false;
  SolverCounts counts_;
};

extern template class FractionalStep<2>;
extern template class FractionalStep<3>;

}  // namespace washfsi
