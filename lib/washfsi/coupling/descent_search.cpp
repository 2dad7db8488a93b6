// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/descent_search.hpp"

#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

namespace {

double norm_of(Vec vector) {
  double norm = 0;
  WASH_PETSC(VecNorm(vector, NORM_2, &norm));
  return norm;
}

}  // namespace

template <int Dim>
void DescentSearch<Dim>::attach(SNES solver, Mat matrix) {
  solver_ = solver;
  matrix_ = matrix;
  SNESLineSearch search = nullptr;
  WASH_PETSC(SNESGetLineSearch(solver, &search));
  WASH_PETSC(SNESLineSearchSetType(search, SNESLINESEARCHSHELL));
  WASH_PETSC(SNESLineSearchShellSetUserFunc(search, &DescentSearch::shorten, this));
}

template <int Dim>
void DescentSearch<Dim>::start(const ClothEquation<Dim>& equation) {
  equation_ = &equation;
  geometric_ = GeometricStiffness::of_tension;
  is_round_off_ = was_stopped_ = false;
}

template <int Dim>
KSP DescentSearch<Dim>::linear_solver() const {
  KSP linear = nullptr;
  WASH_PETSC(SNESGetKSP(solver_, &linear));
  return linear;
}

template <int Dim>
double DescentSearch<Dim>::potential_at(Vec place) const {
  return equation_->potential ? equation_->potential(to_points<Dim>(place)) : 0;
}

template <int Dim>
double DescentSearch<Dim>::size_of(Vec residual, Vec work) const {
  if (equation_->potential) return norm_of(residual);
  PC preconditioner = nullptr;
  WASH_PETSC(KSPGetPC(linear_solver(), &preconditioner));
  WASH_PETSC(PCApply(preconditioner, residual, work));
  return norm_of(work);
}

template <int Dim>
double DescentSearch<Dim>::slope_along(Vec f, Vec direction) const {
  double slope = 0;
  if (equation_->slope)
    slope = equation_->slope(to_points<Dim>(f), to_points<Dim>(direction));
  else
    WASH_PETSC(VecDot(f, direction, &slope));
  return slope;
}

// The step limit of Newton's step, which goes from x against the direction.
template <int Dim>
double DescentSearch<Dim>::step_limit(Vec x, Vec direction) const {
  return equation_->step_limit ? equation_->step_limit(to_points<Dim>(x), -1.0 * to_points<Dim>(direction)) : 1;
}

// The slope by which the potential falls along Newton's direction. Where it rises, or the linear solver fails, because
// the matrix was indefinite, the direction is computed again with a positive definite one.
template <int Dim>
double DescentSearch<Dim>::slope_towards_descent(Vec x, Vec f, Vec direction) {
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  WASH_PETSC(KSPGetConvergedReason(linear_solver(), &reason));
  const double slope = slope_along(f, direction);
  if (slope > 0 && reason > 0) return slope;
  geometric_ = GeometricStiffness::of_tension;
  Mat jacobian = nullptr, matrix = nullptr;
  WASH_PETSC(KSPGetOperators(linear_solver(), &jacobian, &matrix));
  if (!equation_->product) jacobian = matrix;  // a Jacobian by differences would not be positive definite
  WASH_PETSC(SNESComputeJacobian(solver_, x, jacobian, matrix));
  WASH_PETSC(KSPSetOperators(linear_solver(), jacobian, matrix));
  WASH_PETSC(KSPSolve(linear_solver(), f, direction));
  const double falls = slope_along(f, direction);
  return falls > 0 ? falls : slope_of_exact_step(f, direction);
}

// If the linear solver stops early, its error in soft modes may exceed their part of the step: solve it exactly.
template <int Dim>
double DescentSearch<Dim>::slope_of_exact_step(Vec f, Vec direction) {
  constexpr double exact = 1e-9;
  double rtol = 0, atol = 0, dtol = 0;
  PetscInt most = 0;
  WASH_PETSC(KSPGetTolerances(linear_solver(), &rtol, &atol, &dtol, &most));
  WASH_PETSC(KSPSetTolerances(linear_solver(), exact, 0, dtol, most));
  WASH_PETSC(KSPSolve(linear_solver(), f, direction));
  WASH_PETSC(KSPSetTolerances(linear_solver(), rtol, atol, dtol, most));
  return slope_along(f, direction);
}

// A potential that falls along the whole of a step as steeply as at its start bends down beyond: Newton's method leaves
// a saddle, as of cloth that buckles, in few steps if these are made longer as long as it falls.
template <int Dim>
double DescentSearch<Dim>::lengthened(Vec x, Vec direction, double slope, double before, Vec trial, Vec f) {
  constexpr int most_doublings = 10;
  constexpr double straight = 0.75;
  double part = 1, least = potential_at(trial);
  if (before - least < straight * slope) return part;
  for (int n = 0; n < most_doublings; ++n) {
    WASH_PETSC(VecWAXPY(trial, -2 * part, direction, x));
    if (!is_free(x, trial)) break;
    const double now = potential_at(trial);
    if (now >= least) break;
    least = now;
    part *= 2;
  }
  WASH_PETSC(VecWAXPY(trial, -part, direction, x));
  WASH_PETSC(SNESComputeFunction(solver_, trial, f));
  return part;
}

template <int Dim>
bool DescentSearch<Dim>::is_free(Vec from, Vec to) const {
  if (!equation_->step_limit) return true;
  const Points<Dim> start = to_points<Dim>(from);
  return equation_->step_limit(start, to_points<Dim>(to) - start) == 1;
}

template <int Dim>
PetscErrorCode DescentSearch<Dim>::shorten(SNESLineSearch search, void* context) {
  return petsc::guarded([&] { static_cast<DescentSearch*>(context)->search(search); });
}

// Halves a part as long as that lowers the potential: a step that ends where facets almost touch is left in many more.
template <int Dim>
double DescentSearch<Dim>::lowest_part(Vec x, Vec direction, double part, Vec trial, Vec f) {
  constexpr int most_halvings = 6;
  const double first = part;
  double least = potential_at(trial);
  for (int n = 0; n < most_halvings; ++n, part *= 0.5) {
    WASH_PETSC(VecWAXPY(trial, -0.5 * part, direction, x));
    const double now = potential_at(trial);
    if (now >= least) break;
    least = now;
  }
  WASH_PETSC(VecWAXPY(trial, -part, direction, x));
  if (part < first) WASH_PETSC(SNESComputeFunction(solver_, trial, f));
  return part;
}

template <int Dim>
void DescentSearch<Dim>::search(SNESLineSearch search) {
  constexpr double sufficient = 1e-4, small = 1e-6;
  constexpr int most_halvings = 30;
  Vec x = nullptr, f = nullptr, direction = nullptr, trial = nullptr, work = nullptr;
  WASH_PETSC(SNESLineSearchGetVecs(search, &x, &f, &direction, &trial, &work));
  const bool has_potential = static_cast<bool>(equation_->potential);
  const bool is_small = norm_of(direction) <= small * norm_of(x);  // so near the solution residuals may be round-off
  const double size = size_of(f, work), slope = has_potential ? slope_towards_descent(x, f, direction) : 0;
  const double before = potential_at(x);
  double part = step_limit(x, direction);
  for (int n = 0; n < most_halvings; ++n, part *= 0.5) {
    WASH_PETSC(VecWAXPY(trial, -part, direction, x));
    WASH_PETSC(SNESComputeFunction(solver_, trial, f));
    const double now = size_of(f, work);
    is_round_off_ = !has_potential && now <= equation_->round_off;
    const bool lowers = is_small || is_round_off_ || now <= (1 - sufficient * part) * size;
    if (lowers || (has_potential && potential_at(trial) <= before - sufficient * part * slope)) {
      if (has_potential && !is_small && part == 1) part = lengthened(x, direction, slope, before, trial, f);
      if (has_potential && equation_->step_limit && !is_small && part <= 1)
        part = lowest_part(x, direction, part, trial, f);
      return accept(search, part);
    }
  }
  WASH_PETSC(SNESLineSearchSetReason(search, SNES_LINESEARCH_FAILED_REDUCT));
}

template <int Dim>
void DescentSearch<Dim>::accept(SNESLineSearch search, double part) {
  Vec x = nullptr, f = nullptr, direction = nullptr, trial = nullptr, work = nullptr;
  WASH_PETSC(SNESLineSearchGetVecs(search, &x, &f, &direction, &trial, &work));
  WASH_PETSC(VecCopy(trial, x));
  WASH_PETSC(VecScale(direction, part));
  WASH_PETSC(SNESLineSearchSetLambda(search, part));
  WASH_PETSC(SNESLineSearchSetReason(search, SNES_LINESEARCH_SUCCEEDED));
  WASH_PETSC(SNESLineSearchComputeNorms(search));
  was_stopped_ = part < 1 && equation_->step_limit;
  geometric_ = part >= 1 && equation_->potential ? GeometricStiffness::all : GeometricStiffness::of_tension;
}

template class DescentSearch<2>;
template class DescentSearch<3>;

}  // namespace washfsi
