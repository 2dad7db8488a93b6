// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/forces.hpp"
#include "washfsi/coupling/cloth_solver.hpp"
#include "washfsi/coupling/step_mobility.hpp"

namespace washfsi {

/// The cloths' equations where something limits their motion, in a step from X with the mobility M, symmetric and
/// positive, and the water's velocity U before the forces change by y:
///   V = U + N y,     y = F(X + dt V) - F,     N = dt M
/// Newton's steps,  (1 + dt N K) dV = -(V - U - N y(V)),  by GMRES with the preconditioner 1 + dt^2 D K, D the row sums
/// of M. They are shortened to the step limit, and further until the preconditioned residual falls.
/// Where that fails, the equations are solved for y, since for V they have no potential without M^-1:
///   phi(y) = 1/2 y.N y + E(X + dt V)/dt + F.V     has the gradient  N (y - F(X + dt V) + F)
/// and falls along Newton's steps,  (1 + dt K N) dy = -(y - ...).
template <int Dim>
class ForceEquation {
 public:
  /// The solver must outlive it.
  explicit ForceEquation(ClothSolver<Dim>& solver) : solver_(solver) {}

  struct Step {
    Forces<Dim>& all;                     ///< forces on the cloths
    double dt;                            ///< length of the step [s]
    const Points<Dim>& start;             ///< X, from which the step limit counts [m]
    const Points<Dim>& water_velocities;  ///< U [m/s]
    const Points<Dim>& forces;            ///< F, already contained in U [N]
    const StepMobility<Dim>& mobility;    ///< M, D [1/kg]
    double tolerance;                     ///< tolerance of the velocities' 2-norm [m/s]
  };
  /// Returns V, starting from the best of the guesses, with forces that are sharp there. Adds the evaluations to
  /// `iterations`. Collective. Errors: DivergedError.
  Points<Dim> solve(const Step& step, std::vector<Points<Dim>> guesses, double& iterations);

  /// U + N y with a share of U. Collective.
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
  std::vector<double> diagonal(const Step& step) const;

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
