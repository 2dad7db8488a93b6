// SPDX-License-Identifier: BSD-3-Clause
//
// The incremental semi-implicit step: one solution of the cloth's equations and two projections. H is the fluid
// fraction of each face and u_H = H u + (1-H) u_solid. W is the velocity of the markers in the step. F is the sum of
// all forces that depend on the places of the markers alone: elasticity, holding springs, contact and inertia, with the
// bodies where they are at that time. The weights (w_0, w_1, w_2) are those of the end of the step, of its start and of
// the start of the step before, of force and velocity alike:
//   order 1      (1, 0, 0)                              backward Euler
//   order 2      (9/16, 7/16 - chi/16, chi/16)          chi: this step over the last; the first step is backward Euler
//   1. spread      S, J, rho at X^n + dt/2 V^n;  f = S (w_0 F + w_1 F^n + w_2 F^(n-1) + weight, loads). The first guess
//                  is F = F^n + F_inertia^n/w_0, with the force of inertia of the previous step
//   2. fluid       u, p by the fractional step with f
//   3. markers     U = J (w_0 u + w_1 u^n + w_2 u^(n-1))_H. With seepage B F_f is added to U, with a wall model r
//                  too, and M + w_0 B/dt replaces M from item 4 on (coupling/seepage.hpp)
//   4. mobility    M = factor times w_0^2 times the mobility J H S / rho, as a sparse matrix or, where that is faster,
//                  as the product itself. With the pressure markers yield less than this. D is the diagonal of its row
//                  sums. A linear oscillator without mass and further sweeps is stable for any step if factor >= 3/4
//                  with order 1, 0.95 with order 2 (docs/theory/coupling.md); a heavy plate needs 1
//   5. elasticity  W - U = dt M [F(X^n + dt W) - F], by Newton's method. With D the equations are the gradient of a
//                  potential; with M they are solved by GMRES, preconditioned by those with D. Where contact limits
//                  the motion, see coupling/force_equation.hpp
//   6. correction  u += dt/rho w_0 H S [F(X^n + dt W) - F], projected;  F = F(X^n + dt W)
//   7. slip        |W - U| / |W| with the new u; above a tolerance 5 and 6 again with that U, a few times at most; of
//                  packed loads with 3/4 of M, since the pressure resists most of the remaining slip
//   8. markers     X^(n+1) = X^n + dt W;  V^(n+1) = W, or, with order 2, W extrapolated to the end
// Backward Euler damps like a Kelvin-Voigt damping time of dt/2 to dt; the scheme ignores -NAME_damping. Order 2 leaves
// smooth motions undamped and reduces stiff ones to a third in each step. It has the weights of the modified
// Crank-Nicolson/Adams-Bashforth scheme (Ascher, Ruuth and Wetton, SIAM J. Numer. Anal. 32 (1995) 797), for force and
// velocity alike.
#pragma once

#include "washfsi/coupling/cloth_solver.hpp"
#include "washfsi/coupling/coupling_scheme.hpp"
#include "washfsi/coupling/force_equation.hpp"
#include "washfsi/coupling/seepage.hpp"
#include "washfsi/coupling/step_mobility.hpp"

namespace washfsi {

/// The weights w_0, w_1 and w_2, in the mean force and velocity of a step, of their values at its end, at its start and
/// at the start of the step before.
struct StepWeights {
  double end = 1, start = 0, before = 0;
};

template <int Dim>
class SemiImplicitCoupling : public CouplingScheme<Dim> {
 public:
  static constexpr bool takes_inertia = true;
  static constexpr bool takes_seepage = true;

  /// Collective. Errors: InputError if a force has no Jacobian, or the mobility's matrix is not symmetric where it has
  /// to be.
  SemiImplicitCoupling(System<Dim>& system, const CouplingOptions& options);
  double step_bound(const System<Dim>& system) const override;

 private:
  void advance_fields(System<Dim>& system, double dt) override;
  void set_weights(const System<Dim>& system, double dt);
  void find_explicit_velocity(const System<Dim>& system);
  /// Interpolates the step's mean velocity of the water to the markers.
  Points<Dim> water_velocities(const System<Dim>& system, double dt) const;
  /// Adds the velocity of seepage to it: B F_f, with a wall model r too.
  Points<Dim> reached_velocities(const System<Dim>& system, double dt) const;
  void prepare_end_forces(System<Dim>& system, double dt) const;
  void iterate(System<Dim>& system, double dt, Points<Dim> forces, Points<Dim> interpolated);
  /// Solves item 5 for W from U and F. Collective. Errors: DivergedError.
  Points<Dim> solve_velocities(System<Dim>& system, double dt, const Points<Dim>& free_velocities,
                               const Points<Dim>& forces);
  Points<Dim> solve_by_matrix(System<Dim>& system, double dt, const Points<Dim>& free_velocities,
                              const Points<Dim>& forces, double tolerance);
  Points<Dim> solve_by_forces(System<Dim>& system, double dt, const Points<Dim>& free_velocities,
                              const Points<Dim>& forces, double tolerance);
  Points<Dim> solve_by_row_sums(System<Dim>& system, double dt, const Points<Dim>& free_velocities,
                                const Points<Dim>& forces, double tolerance);
  double slip(MPI_Comm comm, const Points<Dim>& interpolated) const;

  CouplingOptions options_;
  StepWeights weights_;
  petsc::Vector explicit_velocity_;  ///< the part of the mean velocity known before the step; null in first order
  ClothSolver<Dim> solver_;
  ForceEquation<Dim> force_equation_;
  StepMobility<Dim> mobility_;  ///< M, D of the current step
  Seepage<Dim> seepage_;
  Points<Dim> velocities_;  ///< W
  Points<Dim> change_;      ///< guess of the forces' change in the current step, for its first sweep
};

}  // namespace washfsi
