// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/forces.hpp"
#include "washfsi/coupling/cloth_solver.hpp"
#include "washfsi/coupling/step_mobility.hpp"

namespace washfsi {

/// The cloths' equations where something limits their motion. In a step from X^n, with the velocity U of the water
/// before the forces change by lambda, the velocities W of the markers are
///   W = U + M~ lambda,     lambda(W) = F(X^n + dt W) - F,     M~ = dt M
/// M here is that of `StepMobility`, additions included; it is symmetric and positive. In the theory's M:
///   M~ = dt (M + 10^-2 diag M) + w_0 B
/// Newton's steps  (I + dt M~ K) dW = -(W - U - M~ lambda(W))  are found by GMRES with the preconditioner I + dt^2 D K.
/// D has the row sums of the mobility without these additions, and the blocks of permeance and wall model. The steps
/// are shortened to the step limit, and further until the preconditioned residual falls.
/// Where that fails, the equations are solved for lambda, since in W they have no potential without M^-1:
///   Pi(lambda) = 1/2 lambda.M~ lambda + Psi(X^n + dt W)/dt + F.W   has the gradient  M~ (lambda - F(X^n + dt W) + F)
/// and falls along Newton's steps  (I + dt K M~) dlambda = -(lambda - F(X^n + dt W) + F).  Their preconditioner
/// I + dt^2 K D has the row sums alone.
template <int Dim>
class ForceEquation {
 public:
  /// The solver must outlive it.
  explicit ForceEquation(ClothSolver<Dim>& solver) : solver_(solver) {}

  struct Step {
    Forces<Dim>& all;                     ///< forces on the cloths
    double dt;                            ///< length of the step [s]
    const Points<Dim>& start;             ///< X^n, from which the step limit counts [m]
    const Points<Dim>& water_velocities;  ///< U [m/s]
    const Points<Dim>& forces;            ///< F, already contained in U [N]
    const StepMobility<Dim>& mobility;    ///< M, D [1/kg]
    double tolerance;                     ///< tolerance of the velocities' 2-norm [m/s]
  };
  /// Returns W, starting from the best of the guesses, with forces that are sharp there. Adds the evaluations to
  /// `iterations`. Collective. Errors: DivergedError.
  Points<Dim> solve(const Step& step, std::vector<Points<Dim>> guesses, double& iterations);

  /// U + M~ lambda with a share of U, for a change lambda of the forces. Collective.
  Points<Dim> velocities(const Step& step, double share, const Points<Dim>& change) const;

 private:
  Points<Dim> solve_once(const Step& step, const std::vector<Points<Dim>>& guesses, double& iterations);
  Points<Dim> residual(const Step& step, double share, const Points<Dim>& all) const;
  bool is_free(const Step& step, const Points<Dim>& all) const;
  void solve_at(const Step& step, double share, Points<Dim>& all, double& iterations);
  Points<Dim> solved_for_forces(const Step& step, double share, const Points<Dim>& guess, double& iterations);
  Points<Dim> solved_by_shares(const Step& step, double& iterations);
  ClothEquation<Dim> of_velocities(const Step& step, double share);
  ClothEquation<Dim> of_forces(const Step& step, double share);
  double potential(const Step& step, double share, const Points<Dim>& change) const;
  void set_stiffness(const Step& step, const Points<Dim>& places, GeometricStiffness geometric, Mat matrix);

  ClothSolver<Dim>& solver_;
  petsc::Matrix stiffness_;  ///< K where it was assembled last
  MatrixProduct<Dim> product_;
  std::vector<long> pattern_;  ///< pattern for which K was laid out
};

/// Checks that the mobility's matrix is symmetric where it has to be. Errors: InputError.
template <int Dim>
void check_symmetry(const Model<Dim>& model);

extern template class ForceEquation<2>;
extern template class ForceEquation<3>;

}  // namespace washfsi
