// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// Refuses numbers in a solver's options that PETSc accepts unchecked and crashes on. Errors: InputError.
void refuse_deadly_options(const std::string& prefix);

/// The options that the user gave for a solver, as typed.
std::string options_with_prefix(const std::string& prefix);

/// Reads the solver's options and sets it up, so that a wrong setting is met before the first step.
/// Returns whether the user fixed the absolute tolerance himself. Collective. Errors: InputError.
bool set_up_from_options(KSP solver);

/// Solves with an absolute residual tolerance and returns the iterations. Collective.
/// Errors: DivergedError naming `what` and PETSc's reason.
PetscInt solve_to(KSP solver, double tolerance, Vec rhs, Vec solution, const std::string& what);

}  // namespace washfsi
