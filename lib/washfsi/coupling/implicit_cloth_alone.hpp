// SPDX-License-Identifier: BSD-3-Clause
//
// Cloth without fluid by backward Euler, for steps that are long for stiff cloth and hard contact. It dissipates energy
// and never adds any. With the masses m of the markers, the drag c per undeformed area A, and all forces F that depend
// on places:
//   1. markers   m (W - V^n)/dt + c A W = F(X^n + dt W) + weight, loads: the gradient of a potential, by Newton's
//                method with steps shortened to the step limit (in two halves where this fails, and these again)
//   2. markers   X^(n+1) = X^n + dt W;  V^(n+1) = W
// It damps by itself; -..._damping is not used.
#pragma once

#include "washfsi/coupling/cloth_solver.hpp"
#include "washfsi/coupling/coupling_scheme.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

template <int Dim>
class ImplicitClothAlone : public CouplingScheme<Dim> {
 public:
  /// Collective. Errors: InputError if a force has no Jacobian.
  ImplicitClothAlone(System<Dim>& system, const CouplingOptions& options);
  double step_bound(const System<Dim>& system) const override;

 private:
  void advance_fields(System<Dim>& system, double dt) override;
  void take_part(System<Dim>& system, double start, double dt, int halvings);
  void solve(System<Dim>& system, double start, double dt);
  ClothEquation<Dim> equation(System<Dim>& system, double dt);
  Points<Dim> guess(System<Dim>& system, double dt, const ClothEquation<Dim>& equation) const;
  double tolerance(const System<Dim>& system, double dt) const;

  CouplingOptions options_;
  ClothSolver<Dim> solver_;
  Mat jacobian_ = nullptr;  ///< the solver's matrix, where it was assembled last
  MatrixProduct<Dim> product_;
};

}  // namespace washfsi
