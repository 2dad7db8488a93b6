// SPDX-License-Identifier: BSD-3-Clause
//
// The incremental semi-implicit step: one solve of the cloth's equations and two projections, backward Euler in the
// stiff part. H is the fluid fraction of each face, V the markers' velocity, F the sum of all forces that depend on the
// markers' places alone, of elasticity, holding springs and contact, with the bodies where they are at that time.
//   1. spread      S, J, rho at X^n + dt/2 V^n;  F = F(X^n), as the last step left it;  f = S (F + weight, loads)
//   2. fluid       u, p by the fractional step with f
//   3. markers     U = J [H u + (1-H) u_solid]
//   4. mobility    M = factor times J H S / rho, a sparse matrix that bounds the true mobility of the markers, that of
//                  cloths lying on each other included; or, D, its row sums, a diagonal. Stable for any step if factor
//                  >= 3/4 and the density is nearly uniform; a heavy plate needs 1
//   5. elasticity  V - U = dt M [F(X^n + dt V) - F], by Newton's method. With D the equations are the gradient of a
//                  potential; with M they are solved by GMRES, preconditioned by those with D
//   6. correction  f' = H S [F(X^n + dt V) - F]: u += dt f'/rho, projected;  F = F(X^n + dt V)
//   7. slip        |V - J u| / |V|; above a tolerance 5 and 6 again with U = J u, a few times at most
//   8. markers     X^(n+1) = X^n + dt V
// Backward Euler damps as a Kelvin-Voigt time between dt and 2 dt does; -..._damping is not used.
#pragma once

#include "washfsi/coupling/mobility.hpp"
#include "washfsi/scheme/cloth_solver.hpp"
#include "washfsi/scheme/coupling_scheme.hpp"

namespace washfsi {

template <int Dim>
class SemiImplicitCoupling : public CouplingScheme<Dim> {
 public:
  static constexpr bool takes_inertia = true;

  SemiImplicitCoupling(const System<Dim>& system, const CouplingOptions& options);
  double step_bound(const System<Dim>& system) const override;

 private:
  void take(System<Dim>& system, double dt) override;
  void find_mobility(const Model<Dim>& model, const Points<Dim>& places);
  void sweep(System<Dim>& system, double dt, Points<Dim> forces, Points<Dim> interpolated);
  /// V from U and F. Collective. Errors: DivergedError.
  Points<Dim> move(System<Dim>& system, double dt, const Points<Dim>& free_velocities, const Points<Dim>& forces);
  Points<Dim> move_by_matrix(System<Dim>& system, double dt, const Points<Dim>& free_velocities,
                             const Points<Dim>& forces, double tolerance);
  Points<Dim> move_by_row_sums(System<Dim>& system, double dt, const Points<Dim>& free_velocities,
                               const Points<Dim>& forces, double tolerance);
  double slip(MPI_Comm comm, const Points<Dim>& interpolated) const;

  CouplingOptions options_;
  ClothSolver<Dim> solver_;
  MobilityMatrix<Dim> matrix_;    ///< J H S / rho of the step under way
  std::vector<double> row_sums_;  ///< D of each of this rank's markers
  Points<Dim> velocities_;        ///< V
};

}  // namespace washfsi
