// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/cloth_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "washfsi/simulation/marker_vectors.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

// Whether the user sets an option of the cloth's solvers, or a default of ours has.
bool is_given(const char* option) {
  PetscBool given = PETSC_FALSE;
  WASH_PETSC(PetscOptionsHasName(nullptr, "cloth_", option, &given));
  return given == PETSC_TRUE;
}

}  // namespace

template <int Dim>
ClothSolver<Dim>::ClothSolver(const Cloths<Dim>& cloths, const Points<Dim>& positions, const Defaults& defaults)
    : cloths_(cloths), matrix_(cloths.stiffness_matrix()) {
  WASH_PETSC(MatCreateVecs(matrix_, unknown_.put(), value_.put()));
  WASH_PETSC(SNESCreate(cloths.comm(), solver_.put()));
  WASH_PETSC(SNESSetOptionsPrefix(solver_, "cloth_"));
  WASH_PETSC(SNESSetFunction(solver_, value_, &ClothSolver::evaluate, this));
  set_default_solvers(defaults);
  if (approximate_) WASH_PETSC(SNESSetConvergenceTest(solver_, &ClothSolver::test_convergence, this, nullptr));
  WASH_PETSC(SNESSetTolerances(solver_, 0, 1e-10, defaults.approximate ? 1e-7 : 1e-10, 60, 10000));
  const petsc::MutedErrors muted;
  try {
    WASH_PETSC(SNESSetFromOptions(solver_));
    if (solves_linearly_) set_up_linear_solver(positions);
  } catch (const petsc::Error&) {
    throw InputError("-cloth_...: the solver of the cloth cannot be set up with this (" + muted.message() + ")");
  }
  if (approximate_) {
    PetscInt rows = 0;
    WASH_PETSC(VecGetLocalSize(unknown_, &rows));
    WASH_PETSC(MatCreateShell(cloths.comm(), rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, this, matrix_free_.put()));
    WASH_PETSC(MatShellSetOperation(matrix_free_, MATOP_MULT, reinterpret_cast<void (*)()>(&ClothSolver::multiply)));
  } else if (applies_matrix_free()) {
    WASH_PETSC(MatCreateSNESMF(solver_, matrix_free_.put()));
  }
  const Mat jacobian = matrix_free_ ? matrix_free_ : matrix_;
  WASH_PETSC(SNESSetJacobian(solver_, jacobian, matrix_, &ClothSolver::linearise, this));
  user_sets_atol_ = is_given("-snes_atol");
}

// At once, so that all options are read, and wrong ones found, before the first step.
template <int Dim>
void ClothSolver<Dim>::set_up_linear_solver(const Points<Dim>& positions) {
  cloths_.set_stiffness(positions, GeometricStiffness::of_tension, 1, matrix_);
  const std::vector<double> ones(positions.size(), 1.0);
  scale_and_shift<Dim>(ones, ones, matrix_);
  KSP linear = nullptr;
  WASH_PETSC(SNESGetKSP(solver_, &linear));
  WASH_PETSC(KSPSetOperators(linear, matrix_, matrix_));
  WASH_PETSC(KSPSetUp(linear));
  KSPNormType norm = KSP_NORM_DEFAULT;
  WASH_PETSC(KSPGetNormType(linear, &norm));
  aims_linear_solver_ = approximate_ && norm == KSP_NORM_UNPRECONDITIONED && !is_given("-ksp_atol");
}

// A direct solution, of all cloths by every rank, of fibres: they are small, and the result does not depend on the
// ranks. Sheets would fill its factors; as a preconditioner an incomplete one is as good. Only what the chosen method
// reads may be set.
template <int Dim>
void ClothSolver<Dim>::set_default_solvers(const Defaults& defaults) {
  WASH_PETSC(SNESSetType(solver_, defaults.type));
  std::array<char, 64> type{};
  WASH_PETSC(PetscOptionsGetString(nullptr, "cloth_", "-snes_type", type.data(), type.size(), nullptr));
  const std::string chosen = type[0] ? type.data() : defaults.type;
  const bool newton = chosen == SNESNEWTONLS || chosen == SNESNEWTONTR;
  if (chosen == SNESQN) {
    petsc::set_default_option("-cloth_snes_qn_type", "broyden");
    petsc::set_default_option("-cloth_snes_qn_scale_type", "jacobian");
    petsc::set_default_option("-cloth_snes_linesearch_type", "basic");
  }
  if (newton && std::string(defaults.type) == SNESNEWTONLS) {
    SNESLineSearch search = nullptr;
    WASH_PETSC(SNESGetLineSearch(solver_, &search));
    WASH_PETSC(SNESLineSearchSetType(search, SNESLINESEARCHSHELL));
    WASH_PETSC(SNESLineSearchShellSetUserFunc(search, &ClothSolver::shorten, this));
  }
  approximate_ = defaults.approximate && newton;
  solves_linearly_ = newton || chosen == SNESQN;
  if (!solves_linearly_) return;
  const bool preconditions = newton && (defaults.approximate || std::string(defaults.type) == SNESQN);
  const bool chooses = is_given("-pc_type"), chooses_method = is_given("-ksp_type");
  if (!chooses && preconditions && Dim == 3) {
    petsc::set_default_option("-cloth_pc_type", "bjacobi");
    petsc::set_default_option("-cloth_sub_pc_type", "ilu");
  } else if (!chooses) {
    petsc::set_default_option("-cloth_pc_type", "redundant");
    petsc::set_default_option("-cloth_redundant_pc_type", defaults.symmetric ? "cholesky" : "lu");
  }
  petsc::set_default_option("-cloth_ksp_type", preconditions ? "gmres" : "preonly");
  if (!preconditions) return;
  if (approximate_ && !chooses_method) petsc::set_default_option("-cloth_ksp_pc_side", "right");  // see aim_at
  petsc::set_default_option("-cloth_ksp_rtol", defaults.approximate ? "1e-3" : "1e-2");
  petsc::set_default_option("-cloth_ksp_gmres_restart", "200");  // stiff short waves that water hardly moves
}

// Newton's method where the assembled matrix is not the Jacobian itself.
template <int Dim>
bool ClothSolver<Dim>::applies_matrix_free() const {
  std::array<char, 64> type{};
  WASH_PETSC(PetscOptionsGetString(nullptr, "cloth_", "-ksp_type", type.data(), type.size(), nullptr));
  return solves_linearly_ && std::string(type.data()) != KSPPREONLY;
}

template <int Dim>
PetscErrorCode ClothSolver<Dim>::evaluate(SNES solver, Vec x, Vec f, void* context) {
  auto& self = *static_cast<ClothSolver*>(context);
  return petsc::guarded([&] {
    ++self.evaluations_;
    try {
      to_vector<Dim>(self.equation_->residual(to_points<Dim>(x, self.cloths_.owned())), f);
    } catch (const DivergedError&) {
      self.failure_ = std::current_exception();
      WASH_PETSC(VecSet(f, 0));
      WASH_PETSC(SNESSetFunctionDomainError(solver));
    }
  });
}

// How fast the potential falls along Newton's direction. Where the matrix was not positive definite and it rises, the
// direction is found anew with one that is.
template <int Dim>
double ClothSolver<Dim>::slope_towards_descent(Vec x, Vec f, Vec direction) {
  double slope = 0;
  WASH_PETSC(VecDot(f, direction, &slope));
  if (slope > 0) return slope;
  geometric_ = GeometricStiffness::of_tension;
  KSP linear = nullptr;
  WASH_PETSC(SNESGetKSP(solver_, &linear));
  WASH_PETSC(SNESComputeJacobian(solver_, x, matrix_, matrix_));
  WASH_PETSC(KSPSetOperators(linear, matrix_, matrix_));
  WASH_PETSC(KSPSolve(linear, f, direction));
  WASH_PETSC(VecDot(f, direction, &slope));
  return slope;
}

// The size of what Newton's step would still change (Deuflhard's natural level function, with the preconditioner in
// place of the Jacobian): a residual's own norm sees little but the stiffest waves.
template <int Dim>
double ClothSolver<Dim>::preconditioned_norm(Vec f, Vec work) const {
  KSP linear = nullptr;
  PC preconditioner = nullptr;
  WASH_PETSC(SNESGetKSP(solver_, &linear));
  WASH_PETSC(KSPGetPC(linear, &preconditioner));
  WASH_PETSC(PCApply(preconditioner, f, work));
  double norm = 0;
  WASH_PETSC(VecNorm(work, NORM_2, &norm));
  return norm;
}

// PETSc's own test, and an end where what is left is round-off.
template <int Dim>
PetscErrorCode ClothSolver<Dim>::test_convergence(SNES solver, PetscInt iteration, PetscReal unknown, PetscReal step,
                                                  PetscReal residual, SNESConvergedReason* reason, void* context) {
  return petsc::guarded([&] {
    WASH_PETSC(SNESConvergedDefault(solver, iteration, unknown, step, residual, reason, nullptr));
    const auto& self = *static_cast<ClothSolver*>(context);
    if (*reason == SNES_CONVERGED_ITERATING && self.is_round_off_) *reason = SNES_CONVERGED_SNORM_RELATIVE;
  });
}

template <int Dim>
PetscErrorCode ClothSolver<Dim>::multiply(Mat jacobian, Vec x, Vec y) {
  return petsc::guarded([&] {
    void* context = nullptr;
    WASH_PETSC(MatShellGetContext(jacobian, &context));
    const auto& self = *static_cast<ClothSolver*>(context);
    to_vector<Dim>(self.equation_->product(to_points<Dim>(x, self.cloths_.owned())), y);
  });
}

// A step along Newton's direction: the whole of it, or a half, a quarter ... of it, the first that lowers the potential
// or, near the solution, where differences of the potential drown in round-off, the residual.
template <int Dim>
PetscErrorCode ClothSolver<Dim>::shorten(SNESLineSearch search, void* context) {
  auto& self = *static_cast<ClothSolver*>(context);
  return petsc::guarded([&] {
    constexpr double sufficient = 1e-4, small = 1e-6;
    constexpr int most_halvings = 30;
    Vec x = nullptr, f = nullptr, direction = nullptr, trial = nullptr, work = nullptr;
    WASH_PETSC(SNESLineSearchGetVecs(search, &x, &f, &direction, &trial, &work));
    const Equation& equation = *self.equation_;
    const bool has_potential = static_cast<bool>(equation.potential);
    const auto potential_at = [&](Vec place) {
      return has_potential ? equation.potential(to_points<Dim>(place, self.cloths_.owned())) : 0.0;
    };
    const auto norm_of = [&](Vec residual) {
      double norm = 0;
      if (!has_potential) return self.preconditioned_norm(residual, work);
      WASH_PETSC(VecNorm(residual, NORM_2, &norm));
      return norm;
    };
    double part = 1, step_norm = 0, place_norm = 0;
    WASH_PETSC(VecNorm(direction, NORM_2, &step_norm));
    WASH_PETSC(VecNorm(x, NORM_2, &place_norm));
    const bool is_small = step_norm <= small * place_norm;  // so near the solution residuals may be round-off
    const double norm = norm_of(f), slope = has_potential ? self.slope_towards_descent(x, f, direction) : 0;
    const double before = potential_at(x);
    for (int n = 0; n < most_halvings; ++n, part *= 0.5) {
      WASH_PETSC(VecWAXPY(trial, -part, direction, x));
      WASH_PETSC(SNESComputeFunction(self.solver_, trial, f));
      const double now = norm_of(f);
      self.is_round_off_ = !has_potential && now <= equation.round_off;
      const bool lowers = is_small || self.is_round_off_ || now <= (1 - sufficient * part) * norm;
      if (lowers || (has_potential && potential_at(trial) <= before - sufficient * part * slope)) {
        WASH_PETSC(VecCopy(trial, x));
        WASH_PETSC(VecScale(direction, part));
        WASH_PETSC(SNESLineSearchSetLambda(search, part));
        WASH_PETSC(SNESLineSearchSetReason(search, SNES_LINESEARCH_SUCCEEDED));
        WASH_PETSC(SNESLineSearchComputeNorms(search));
        self.geometric_ = part == 1 && has_potential ? GeometricStiffness::all : GeometricStiffness::of_tension;
        return;
      }
    }
    WASH_PETSC(SNESLineSearchSetReason(search, SNES_LINESEARCH_FAILED_REDUCT));
  });
}

template <int Dim>
PetscErrorCode ClothSolver<Dim>::linearise(SNES, Vec x, Mat jacobian, Mat matrix, void* context) {
  auto& self = *static_cast<ClothSolver*>(context);
  return petsc::guarded([&] {
    self.equation_->assemble(to_points<Dim>(x, self.cloths_.owned()), self.geometric_, matrix);
    if (jacobian == matrix) return;
    WASH_PETSC(MatAssemblyBegin(jacobian, MAT_FINAL_ASSEMBLY));
    WASH_PETSC(MatAssemblyEnd(jacobian, MAT_FINAL_ASSEMBLY));
  });
}

// A quasi-Newton method would go on with the matrix of the step before, which a restarted run does not know.
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

// Newton's last linear solution need not be better than its equation's tolerance asks: most of the iterations are its.
// Possible where the linear solver sees the residual itself, as it does with the preconditioner on the right.
template <int Dim>
void ClothSolver<Dim>::aim_at(double residual) {
  constexpr double part = 0.3;  // the rest for what is not linear
  KSP linear = nullptr;
  WASH_PETSC(SNESGetKSP(solver_, &linear));
  WASH_PETSC(KSPSetTolerances(linear, PETSC_DEFAULT, part * residual, PETSC_DEFAULT, PETSC_DEFAULT));
}

template <int Dim>
PetscInt ClothSolver<Dim>::solve(const Equation& equation, double tolerance, Points<Dim>& velocities) {
  forget_last_solve();
  equation_ = &equation;
  geometric_ = GeometricStiffness::of_tension;
  is_round_off_ = false;
  failure_ = nullptr;
  evaluations_ = 0;
  double atol = 0, rtol = 0, stol = 0;
  PetscInt most_iterations = 0, most_evaluations = 0;
  WASH_PETSC(SNESGetTolerances(solver_, &atol, &rtol, &stol, &most_iterations, &most_evaluations));
  if (!user_sets_atol_) {
    const double enough = std::max({tolerance, equation.round_off, 1e-300});
    WASH_PETSC(SNESSetTolerances(solver_, enough, rtol, stol, most_iterations, most_evaluations));
    if (aims_linear_solver_) aim_at(enough);
  }
  to_vector<Dim>(velocities, unknown_);
  WASH_PETSC(SNESSolve(solver_, nullptr, unknown_));
  if (failure_) std::rethrow_exception(failure_);
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  WASH_PETSC(SNESGetConvergedReason(solver_, &reason));
  if (reason < 0)
    throw DivergedError(std::string("cloth: its equations could not be solved (") + SNESConvergedReasons[reason] +
                        "); a shorter step" + (approximate_ ? " or -cloth_mobility row_sums" : "") + " may help");
  velocities = to_points<Dim>(unknown_, cloths_.owned());
  return evaluations_;
}

template class ClothSolver<2>;
template class ClothSolver<3>;

}  // namespace washfsi
