// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// What solves the cloth's equations unless the user chooses otherwise.
struct ClothSolverDefaults {
  SNESType type;   ///< newtonls: the matrix is the Jacobian; qn: it is where the quasi-Newton matrix starts from
  bool symmetric;  ///< whether the matrix is symmetric positive definite: Cholesky instead of LU
  bool approximate = false;  ///< newtonls: the matrix only preconditions the Jacobian, the equation's `product`
};

/// How the equations are solved, with what the user has chosen.
struct ClothSolverPlan {
  bool newton = false;               ///< a method of Newton
  bool searches_descent = false;     ///< with steps shortened by `DescentSearch`
  bool uses_product = false;         ///< with the equation's own product of the Jacobian
  bool has_mobility = false;         ///< and this product holds that of markers in water
  bool solves_linearly = false;      ///< with a linear solver for the matrix
  bool applies_matrix_free = false;  ///< with a Jacobian other than the assembled matrix
};

/// Sets the solvers' defaults in the options database, prefix cloth_, as far as the user has not, and the type of the
/// SNES. `dim`: of space. Collective.
ClothSolverPlan set_cloth_solver_defaults(SNES solver, const ClothSolverDefaults& defaults, int dim);

}  // namespace washfsi
