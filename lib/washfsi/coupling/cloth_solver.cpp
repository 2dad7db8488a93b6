// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/cloth_solver.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/krylov.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

namespace {

constexpr PetscInt iterations_of_a_matrix = 4;  // before the matrix is laid out again: most solutions need no more

}  // namespace

template <int Dim>
ClothSolver<Dim>::ClothSolver(Forces<Dim>& forces, const Points<Dim>& positions, const ClothSolverDefaults& defaults)
    : forces_(forces) {
  lay_out_matrix();
  MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(static_cast<Mat>(matrix_)));
  WASH_PETSC(MatCreateVecs(matrix_, unknown_.put(), value_.put()));
  WASH_PETSC(SNESCreate(comm, solver_.put()));
  WASH_PETSC(SNESSetOptionsPrefix(solver_, "cloth_"));
  WASH_PETSC(SNESSetFunction(solver_, value_, &ClothSolver::evaluate, this));
  plan_ = set_cloth_solver_defaults(solver_, defaults, Dim);
  if (plan_.searches_descent) search_.attach(solver_, matrix_);
  if (plan_.uses_product || plan_.searches_descent)
    WASH_PETSC(SNESSetConvergenceTest(solver_, &ClothSolver::test_convergence, this, nullptr));
  // the line search looks after what the linear solver could not solve
  if (plan_.searches_descent) WASH_PETSC(SNESSetMaxLinearSolveFailures(solver_, 1000));
  WASH_PETSC(SNESSetTolerances(solver_, 0, 1e-10, defaults.approximate ? 1e-7 : 1e-10, 60, 10000));
  refuse_deadly_options("cloth_");
  const petsc::MutedErrors muted;
  try {
    WASH_PETSC(SNESSetFromOptions(solver_));
    if (plan_.solves_linearly) set_up_linear_solver(positions);
  } catch (const petsc::Error&) {
    throw InputError(options_with_prefix("cloth_") + ": the solver of the cloth cannot be set up with this (" +
                     muted.message() + ")");
  }
  create_matrix_free_jacobian();
  const Mat jacobian = matrix_free_ ? matrix_free_ : matrix_;
  WASH_PETSC(SNESSetJacobian(solver_, jacobian, matrix_, &ClothSolver::linearise, this));
  user_sets_atol_ = petsc::option_given("cloth_", "-snes_atol");
}

template <int Dim>
void ClothSolver<Dim>::lay_out_matrix() {
  forces_.stiffness().lay_out(matrix_);
  pattern_ = forces_.stiffness().pattern();
}

template <int Dim>
void ClothSolver<Dim>::create_matrix_free_jacobian() {
  if (plan_.uses_product) {
    PetscInt rows = 0;
    WASH_PETSC(VecGetLocalSize(unknown_, &rows));
    WASH_PETSC(MatCreateShell(PetscObjectComm(reinterpret_cast<PetscObject>(static_cast<SNES>(solver_))), rows, rows,
                              PETSC_DETERMINE, PETSC_DETERMINE, this, matrix_free_.put()));
    WASH_PETSC(MatShellSetOperation(matrix_free_, MATOP_MULT, reinterpret_cast<void (*)()>(&ClothSolver::multiply)));
  } else if (plan_.applies_matrix_free) {
    WASH_PETSC(MatCreateSNESMF(solver_, matrix_free_.put()));
  }
}

// Sets the solver up at once, so that all options are read, and wrong ones found, before the first step.
template <int Dim>
void ClothSolver<Dim>::set_up_linear_solver(const Points<Dim>& positions) {
  forces_.stiffness().set(positions, GeometricStiffness::of_tension, 1, matrix_);
  const std::vector<double> ones(positions.size(), 1.0);
  scale_and_shift<Dim>(ones, ones, matrix_);
  KSP linear = nullptr;
  WASH_PETSC(SNESGetKSP(solver_, &linear));
  WASH_PETSC(KSPSetOperators(linear, matrix_, matrix_));
  WASH_PETSC(KSPSetUp(linear));
  KSPNormType norm = KSP_NORM_DEFAULT;
  WASH_PETSC(KSPGetNormType(linear, &norm));
  aims_linear_solver_ =
      plan_.uses_product && norm == KSP_NORM_UNPRECONDITIONED && !petsc::option_given("cloth_", "-ksp_atol");
}

template <int Dim>
PetscErrorCode ClothSolver<Dim>::evaluate(SNES solver, Vec x, Vec f, void* context) {
  auto& self = *static_cast<ClothSolver*>(context);
  return petsc::guarded([&] {
    ++self.evaluations_;
    try {
      to_vector<Dim>(self.equation_->residual(to_points<Dim>(x)), f);
    } catch (const DivergedError&) {
      self.failure_ = std::current_exception();
      WASH_PETSC(VecSet(f, 0));
      WASH_PETSC(SNESSetFunctionDomainError(solver));
    }
  });
}

// PETSc's own test, except that a shortened Newton step does not count as small, and that round-off ends the iteration.
template <int Dim>
PetscErrorCode ClothSolver<Dim>::test_convergence(SNES solver, PetscInt iteration, PetscReal unknown, PetscReal step,
                                                  PetscReal residual, SNESConvergedReason* reason, void* context) {
  return petsc::guarded([&] {
    WASH_PETSC(SNESConvergedDefault(solver, iteration, unknown, step, residual, reason, nullptr));
    auto& self = *static_cast<ClothSolver*>(context);
    if (*reason == SNES_CONVERGED_SNORM_RELATIVE && self.search_.was_stopped()) *reason = SNES_CONVERGED_ITERATING;
    if (*reason == SNES_CONVERGED_ITERATING && self.search_.is_round_off()) *reason = SNES_CONVERGED_SNORM_RELATIVE;
    if (*reason == SNES_CONVERGED_ITERATING && iteration >= iterations_of_a_matrix &&
        self.forces_.stiffness().outgrow_pattern()) {
      self.is_outgrown_ = true;
      *reason = SNES_CONVERGED_ITS;
    }
    if (*reason != SNES_CONVERGED_ITERATING || !self.equation_->is_solved) return;
    Vec value = nullptr;
    WASH_PETSC(SNESGetFunction(solver, &value, nullptr, nullptr));
    if (self.equation_->is_solved(to_points<Dim>(value))) *reason = SNES_CONVERGED_FNORM_ABS;
  });
}

template <int Dim>
PetscErrorCode ClothSolver<Dim>::multiply(Mat jacobian, Vec x, Vec y) {
  return petsc::guarded([&] {
    void* context = nullptr;
    WASH_PETSC(MatShellGetContext(jacobian, &context));
    to_vector<Dim>(static_cast<const ClothSolver*>(context)->equation_->product(to_points<Dim>(x)), y);
  });
}

template <int Dim>
PetscErrorCode ClothSolver<Dim>::linearise(SNES, Vec x, Mat jacobian, Mat matrix, void* context) {
  auto& self = *static_cast<ClothSolver*>(context);
  return petsc::guarded([&] {
    self.equation_->assemble(to_points<Dim>(x), self.search_.geometric(), matrix);
    if (jacobian == matrix) return;
    WASH_PETSC(MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY));
    WASH_PETSC(MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY));
  });
}

// A quasi-Newton method would continue with the matrix of the previous step, which a restarted run does not have.
template <int Dim>
void ClothSolver<Dim>::forget_last_solve() {
  SNESType type = nullptr;
  WASH_PETSC(SNESGetType(solver_, &type));
  const std::string name = type;
  if (name != SNESQN) return;
  WASH_PETSC(SNESSetType(solver_, SNESKSPONLY));
  WASH_PETSC(SNESSetType(solver_, name.c_str()));
  WASH_PETSC(SNESSetFromOptions(solver_));
}

// Newton's last linear solution, which takes most of the iterations, need not be better than the equation's tolerance
// requires. This needs a linear solver that sees the residual itself, as with the preconditioner on the right.
template <int Dim>
void ClothSolver<Dim>::aim_at(double residual) {
  constexpr double part = 0.3;  // share of the tolerance; the rest is for the nonlinear terms
  KSP linear = nullptr;
  WASH_PETSC(SNESGetKSP(solver_, &linear));
  WASH_PETSC(KSPSetTolerances(linear, PETSC_DEFAULT, part * residual, PETSC_DEFAULT, PETSC_DEFAULT));
}

template <int Dim>
void ClothSolver<Dim>::fit_matrix() {
  if (!any_rank(forces_.comm(), pattern_ != forces_.stiffness().pattern())) return;
  lay_out_matrix();
  if (plan_.searches_descent) search_.attach(solver_, matrix_);
  WASH_PETSC(SNESSetJacobian(solver_, matrix_free_ ? matrix_free_ : matrix_, matrix_, &ClothSolver::linearise, this));
}

template <int Dim>
void ClothSolver<Dim>::start(const ClothEquation<Dim>& equation, double tolerance) {
  forget_last_solve();
  fit_matrix();
  equation_ = &equation;
  search_.start(equation);
  failure_ = nullptr;
  evaluations_ = 0;
  if (user_sets_atol_) return;
  double atol = 0, rtol = 0, stol = 0;
  PetscInt most_iterations = 0, most_evaluations = 0;
  WASH_PETSC(SNESGetTolerances(solver_, &atol, &rtol, &stol, &most_iterations, &most_evaluations));
  const double enough = std::max({tolerance, equation.round_off, 1e-300});
  WASH_PETSC(SNESSetTolerances(solver_, enough, rtol, stol, most_iterations, most_evaluations));
  if (aims_linear_solver_) aim_at(enough);
}

// Continues from the present iterate each time contact has outgrown the pattern of the matrix.
template <int Dim>
SNESConvergedReason ClothSolver<Dim>::run() {
  constexpr int most_matrices = 30;
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  for (int n = 0; n < most_matrices; ++n) {
    is_outgrown_ = false;
    WASH_PETSC(SNESSolve(solver_, nullptr, unknown_));
    if (failure_) std::rethrow_exception(failure_);
    WASH_PETSC(SNESGetConvergedReason(solver_, &reason));
    if (!is_outgrown_) return reason;
    forces_.stiffness().renew_pattern();
    fit_matrix();
  }
  return SNES_DIVERGED_MAX_IT;
}

template <int Dim>
PetscInt ClothSolver<Dim>::solve(const ClothEquation<Dim>& equation, double tolerance, Points<Dim>& velocities) {
  start(equation, tolerance);
  to_vector<Dim>(velocities, unknown_);
  const SNESConvergedReason reason = run();
  if (reason < 0)
    throw DivergedError(std::string("cloth: its equations could not be solved (") + SNESConvergedReasons[reason] +
                        "); a shorter step" + (plan_.has_mobility ? " or -coupling_mobility row_sums" : "") +
                        " may help");
  velocities = to_points<Dim>(unknown_);
  return evaluations_;
}

template class ClothSolver<2>;
template class ClothSolver<3>;

}  // namespace washfsi
