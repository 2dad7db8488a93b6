// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "washfsi/fluid/liquid.hpp"
#include "washfsi/grid/boundary.hpp"
#include "washfsi/grid/constraint.hpp"
#include "washfsi/support/petsc.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// The implicit half of a step: u* - (mu dt / 2 rho) lap u* = u_e in fluid, u* = u_solid in solids (4.2-6, 4.2-7),
///   H (u* - (mu dt / 2 rho) lap u* - u_e) + (1 - H) c_diag (u* - u_solid) = 0,
/// where u_e is the right side, `rhs` below, and c_diag the diagonal coefficient of the row of water. Where the
/// viscosity varies, (dt / 2 rho) div tau takes the place of (mu dt / 2 rho) lap u* (`viscous_stress.hpp`).
/// On cut faces the regular part of lap u* acts at both times. What the true place of the wall adds to it (Shortley and
/// Weller, J. Appl. Phys. 9 (1938) 334) acts at the new time with full weight:
///   u* - (mu dt / 2 rho) lap u* - (mu dt / rho) (lap_cut - lap) u* = u_e.
/// Rows are scaled so that the diagonal is near 1. The solver is matrix-free GMRES with Jacobi, PETSc prefix momentum_.
template <int Dim>
class MomentumSolver {
 public:
  /// `tolerance` is the rms residual over the largest speed. Collective.
  MomentumSolver(const Grid<Dim>& grid, const Boundary<Dim>& boundary, double tolerance);

  /// Fixes the coefficients of this step. The vectors must live until the next call. Collective.
  void set_step(double dt, const LiquidFields& liquid, const Constraint<Dim>& constraint);

  /// Solves for u* at time `time`; `velocity` contains a guess and then u*. Collective. Errors: DivergedError.
  void solve(Vec rhs, double time, Vec velocity);
  /// Iterations so far.
  double iterations() const { return iterations_; }
  /// Registers their number.
  void register_state(StateList& state) { state.add_number("/fluid/momentum_iterations", iterations_); }

  /// Finds the constraint force density [N/m3] of the solids on the water, f_solid of the theory:
  /// rho/dt (u* - (mu dt / 2 rho) lap u* - u_e) where H < 1, else 0, with u* the solution for u_e = `rhs`. Collective.
  void constraint_force(Vec rhs, double time, Vec velocity, Vec force) const;

 private:
  static PetscErrorCode multiply(Mat matrix, Vec x, Vec y);
  static PetscErrorCode get_diagonal(Mat matrix, Vec diagonal);
  void apply(Vec x, Vec y) const;
  void residual(Vec rhs, double time, Vec velocity, Vec result) const;
  void find_diagonal(Vec result) const;
  template <class Form, class Visit>
  void visit_cuts(const Form& viscosity, Visit&& visit) const;
  double largest_speed(Vec rhs) const;

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  double tolerance_;
  double dt_ = 0;
  LiquidFields liquid_;
  Constraint<Dim> constraint_;
  std::array<petsc::Version, 3> versions_;  ///< versions of density, fluid fraction and viscosity
  petsc::Matrix matrix_;
  petsc::Solver solver_;
  petsc::Vector residual_, correction_;
  petsc::Vector diagonal_;  ///< diagonal of the fluid rows; null before there are solid ones
  bool user_sets_atol_ = false;
  double iterations_ = 0;
};

extern template class MomentumSolver<2>;
extern template class MomentumSolver<3>;

}  // namespace washfsi
