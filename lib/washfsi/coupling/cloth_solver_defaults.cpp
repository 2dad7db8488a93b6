// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/cloth_solver_defaults.hpp"

namespace washfsi {

namespace {

// Fibres are solved directly, all cloths on every rank: they are small, and the result does not depend on the number of
// ranks. Sheets would fill the factors; as a preconditioner an incomplete factorisation is as good.
void set_preconditioner(const ClothSolverDefaults& defaults, bool only_preconditions, int dim) {
  if (petsc::option_given("cloth_", "-pc_type")) return;
  if (only_preconditions && dim == 3) {
    petsc::set_default_option("-cloth_pc_type", "bjacobi");
    petsc::set_default_option("-cloth_sub_pc_type", defaults.symmetric ? "icc" : "ilu");
    if (defaults.symmetric) petsc::set_default_option("-cloth_sub_pc_factor_shift_type", "positive_definite");
  } else {
    petsc::set_default_option("-cloth_pc_type", "redundant");
    petsc::set_default_option("-cloth_redundant_pc_type", defaults.symmetric ? "cholesky" : "lu");
  }
}

// Conjugate gradients go down a potential however early they stop, as Newton's inexact steps need it. Else with the
// preconditioner on the right: so the linear solver sees the residual itself, and can aim at it.
void set_krylov_method(const ClothSolverDefaults& defaults, bool only_preconditions, bool uses_product) {
  const bool chosen = petsc::option_given("cloth_", "-ksp_type");
  const bool goes_down = only_preconditions && defaults.symmetric && uses_product;
  petsc::set_default_option("-cloth_ksp_type", goes_down ? "cg" : only_preconditions ? "gmres" : "preonly");
  if (!only_preconditions) return;
  petsc::set_default_option("-cloth_ksp_rtol", defaults.approximate ? "1e-3" : "1e-2");
  if (goes_down && !chosen) petsc::set_default_option("-cloth_ksp_norm_type", "unpreconditioned");
  if (goes_down) return;
  if (uses_product && !chosen) petsc::set_default_option("-cloth_ksp_pc_side", "right");
  petsc::set_default_option("-cloth_ksp_gmres_restart", "200");  // stiff short waves that water hardly moves
  // A heavy cloth in a light fluid is so ill-conditioned that the classical Gram-Schmidt process loses orthogonality.
  petsc::set_default_option("-cloth_ksp_gmres_cgs_refinement_type", "refine_ifneeded");
}

void set_quasi_newton() {
  petsc::set_default_option("-cloth_snes_qn_type", "broyden");
  petsc::set_default_option("-cloth_snes_qn_scale_type", "jacobian");
  petsc::set_default_option("-cloth_snes_linesearch_type", "basic");
}

}  // namespace

// Only what the chosen method reads may be set.
ClothSolverPlan set_cloth_solver_defaults(SNES solver, const ClothSolverDefaults& defaults, int dim) {
  WASH_PETSC(SNESSetType(solver, defaults.type));
  const std::string type = defaults.type, chosen = petsc::option_value("cloth_", "-snes_type", type);
  ClothSolverPlan plan;
  plan.newton = chosen == SNESNEWTONLS || chosen == SNESNEWTONTR;
  plan.searches_descent = plan.newton && type == SNESNEWTONLS;
  plan.uses_product = defaults.approximate && plan.newton;
  plan.has_mobility = plan.uses_product && !defaults.symmetric;
  plan.solves_linearly = plan.newton || chosen == SNESQN;
  if (chosen == SNESQN) set_quasi_newton();
  if (!plan.solves_linearly) return plan;
  const bool only_preconditions = plan.newton && (defaults.approximate || type == SNESQN);
  set_preconditioner(defaults, only_preconditions, dim);
  set_krylov_method(defaults, only_preconditions, plan.uses_product);
  plan.applies_matrix_free = petsc::option_value("cloth_", "-ksp_type", "") != KSPPREONLY;
  return plan;
}

}  // namespace washfsi
