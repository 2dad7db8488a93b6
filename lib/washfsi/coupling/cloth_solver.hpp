// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

#include "washfsi/cloth/forces.hpp"
#include "washfsi/coupling/cloth_equation.hpp"
#include "washfsi/coupling/cloth_solver_defaults.hpp"
#include "washfsi/coupling/descent_search.hpp"

namespace washfsi {

/// Solves for the velocities of all markers: a SNES with the options prefix cloth_, whose Jacobian, or the
/// preconditioner of it, is a sparse matrix with the pattern of the forces' stiffness.
template <int Dim>
class ClothSolver {
 public:
  /// `positions` are any possible ones of the cloths. Collective. Errors: InputError.
  ClothSolver(Forces<Dim>& forces, const Points<Dim>& positions, const ClothSolverDefaults& defaults);
  ClothSolver(const ClothSolver&) = delete;
  ClothSolver& operator=(const ClothSolver&) = delete;

  /// Solves an equation until the 2-norm of its residual over all markers is below `tolerance`, or round-off;
  /// `velocities` contains a guess, then the solution. Returns the number of evaluations of the residual. Collective.
  /// Errors: DivergedError.
  PetscInt solve(const ClothEquation<Dim>& equation, double tolerance, Points<Dim>& velocities);

 private:
  static PetscErrorCode evaluate(SNES solver, Vec x, Vec f, void* self);
  static PetscErrorCode test_convergence(SNES solver, PetscInt iteration, PetscReal unknown, PetscReal step,
                                         PetscReal residual, SNESConvergedReason* reason, void* self);
  static PetscErrorCode multiply(Mat jacobian, Vec x, Vec y);
  static PetscErrorCode linearise(SNES solver, Vec x, Mat jacobian, Mat preconditioner, void* self);
  void lay_out_matrix();
  void create_matrix_free_jacobian();
  void set_up_linear_solver(const Points<Dim>& positions);
  void start(const ClothEquation<Dim>& equation, double tolerance);
  void fit_matrix();
  SNESConvergedReason run();
  void forget_last_solve();
  void aim_at(double residual);

  Forces<Dim>& forces_;
  petsc::NonlinearSolver solver_;
  petsc::Matrix matrix_, matrix_free_;
  std::vector<long> pattern_;  ///< pattern of the forces' stiffness for which the matrix was laid out
  petsc::Vector unknown_, value_;
  ClothSolverPlan plan_;
  DescentSearch<Dim> search_;
  const ClothEquation<Dim>* equation_ = nullptr;  ///< during `solve`
  std::exception_ptr failure_;  ///< exception thrown in a callback, kept because it must not cross PETSc's frames
  PetscInt evaluations_ = 0;
  bool is_outgrown_ = false;  ///< whether the solution stopped in order to continue with a larger pattern of the matrix
  bool user_sets_atol_ = false;
  bool aims_linear_solver_ = false;  ///< whether the linear solver's tolerance follows the equation's
};

extern template class ClothSolver<2>;
extern template class ClothSolver<3>;

}  // namespace washfsi
