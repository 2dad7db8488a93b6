// SPDX-License-Identifier: BSD-3-Clause
//
// The implicit step, thesis 3.4 for two dimensions: the markers' velocities W = (X^(n+1) - X^n)/dt solve
//   trapezoidal      W = 1/2 [ U^n + U^(n+1) ]        thesis (3.2-14)
//   backward_euler   W = U^(n+1)                      damps more
// where U^(n+1) = J(X) [H u + (1-H) u_solid] and u is the velocity of the water after a whole step with rho, S and the
// forces at X = X^n + dt W: one solution of the fluid for each evaluation of the residual. With seepage B F_f is
// added to U^(n+1), with a wall model r too. The order is one, since the force of the end acts over the whole step: it
// dissipates energy and never adds any. With w = 1/2 (trapezoidal) or 1, the stiffness K and the row sums D of the
// mobility, Broyden's method (SNES prefix cloth_) starts from  I + w dt^2 D K. Where contact limits the motion,
// coupling iterations replace it: a solution of the fluid with the forces at the last W_k, and that of
//   W_(k+1) - w U^(n+1)(W_k) [- 1/2 U^n] = w dt M [F(X^n + dt W_(k+1)) - F(X^n + dt W_k)]
// (coupling/force_equation.hpp).
#pragma once

#include "washfsi/coupling/cloth_solver.hpp"
#include "washfsi/coupling/coupling_scheme.hpp"
#include "washfsi/coupling/force_equation.hpp"
#include "washfsi/coupling/seepage.hpp"
#include "washfsi/coupling/step_mobility.hpp"

namespace washfsi {

template <int Dim>
class ImplicitCoupling : public CouplingScheme<Dim> {
 public:
  static constexpr bool takes_inertia = true;
  static constexpr bool takes_seepage = true;

  /// Collective. Errors: InputError if contact limits the motion, and a force has no energy or the mobility's matrix is
  /// not symmetric.
  ImplicitCoupling(System<Dim>& system, const CouplingOptions& options);
  double step_bound(const System<Dim>& system) const override;

 private:
  void advance_fields(System<Dim>& system, double dt) override;
  Points<Dim> fluid_step(System<Dim>& system, double dt, const Points<Dim>& velocities) const;
  double tolerance(const System<Dim>& system) const;
  Points<Dim> solve(System<Dim>& system, double dt, Points<Dim>& last);
  Points<Dim> solve_by_sweeps(System<Dim>& system, double dt, Points<Dim>& last);
  bool is_trapezoidal() const { return options_.time_scheme == TimeScheme::trapezoidal; }
  double weight() const { return is_trapezoidal() ? 0.5 : 1; }

  CouplingOptions options_;
  ClothSolver<Dim> solver_;
  ForceEquation<Dim> force_equation_;
  Seepage<Dim> seepage_;
  StepMobility<Dim> mobility_;
};

}  // namespace washfsi
