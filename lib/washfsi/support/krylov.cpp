// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/krylov.hpp"

#include <cmath>
#include <cstdlib>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"
#include "washfsi/support/petsc_options.hpp"

namespace washfsi {

std::string options_with_prefix(const std::string& prefix) {
  std::string text;
  for (const auto& [name, value] : options_in_database())
    if (lower_case(name).starts_with(prefix)) text += (text.empty() ? "-" : " -") + name + " " + value;
  return text;
}

void refuse_deadly_options(const std::string& prefix) {
  static constexpr Range restart{1, 1000, false, "a whole number from 1 to 1000"};
  static constexpr Range levels{1, 30, false, "a whole number from 1 to 30"};
  for (const auto& [option, range] : {std::pair{"ksp_gmres_restart", restart}, {"pc_mg_levels", levels}}) {
    const std::string name = "-" + prefix + option, value = petsc::option_value("", name, "1");
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    if (*end != '\0' || number != std::floor(number) || !range.contains(number))
      throw InputError(name + " " + value + ": must be " + range.text);
  }
}

bool set_up_from_options(KSP solver) {
  const char* prefix = nullptr;
  WASH_PETSC(KSPGetOptionsPrefix(solver, &prefix));
  refuse_deadly_options(prefix);
  const petsc::MutedErrors muted;
  try {
    WASH_PETSC(KSPSetFromOptions(solver));
    WASH_PETSC(KSPSetUp(solver));
  } catch (const petsc::Error&) {
    throw InputError(options_with_prefix(prefix) + ": the solver cannot be set up with this (" + muted.message() + ")");
  }
  return petsc::option_given(prefix, "-ksp_atol");
}

PetscInt solve_to(KSP solver, double tolerance, Vec rhs, Vec solution, const std::string& what) {
  double rtol = 0, atol = 0, dtol = 0;
  PetscInt most = 0;
  WASH_PETSC(KSPGetTolerances(solver, &rtol, &atol, &dtol, &most));
  WASH_PETSC(KSPSetTolerances(solver, rtol, tolerance > 0 ? tolerance : atol, dtol, most));
  WASH_PETSC(KSPSolve(solver, rhs, solution));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  WASH_PETSC(KSPGetConvergedReason(solver, &reason));
  PetscInt iterations = 0;
  WASH_PETSC(KSPGetIterationNumber(solver, &iterations));
  if (reason < 0)
    throw DivergedError(what + ": the linear solver failed after " + std::to_string(iterations) + " iterations (" +
                        KSPConvergedReasons[reason] + ")");
  return iterations;
}

}  // namespace washfsi
