// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// The default solver of the cloth's equations.
struct ClothSolverDefaults {
  SNESType type;             ///< newtonls: the matrix is the Jacobian; qn: the quasi-Newton method starts from it
  bool symmetric;            ///< whether the matrix is symmetric positive definite: Cholesky instead of LU
  bool approximate = false;  ///< newtonls: the matrix only preconditions the Jacobian, the equation's `product`
};

/// How the equations are solved, with what the user has chosen.
struct ClothSolverPlan {
  bool newton = false;               ///< by Newton's method
  bool searches_descent = false;     ///< with steps shortened by `DescentSearch`
  bool uses_product = false;         ///< with the equation's own product of the Jacobian
  bool has_mobility = false;         ///< this product includes the mobility of markers in water
  bool solves_linearly = false;      ///< with a linear solver for the matrix
  bool applies_matrix_free = false;  ///< with a Jacobian other than the assembled matrix
};

/// Sets the solvers' defaults in the options database, prefix cloth_, as far as the user has not, and the type of the
/// SNES. `dim` is the dimension of space. Collective.
ClothSolverPlan set_cloth_solver_defaults(SNES solver, const ClothSolverDefaults& defaults, int dim);

}  // namespace washfsi
