// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "washfsi/grid/grid.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// The projection's Poisson equation (2.2-11, 2.2-28) for phi = dt q / rho_f, which the theory calls q~:
///   -div( (rho_f/rho) grad phi ) = -div u*,   n . grad phi = 0 on the boundary,    each times the cell volume dx.
/// After the correction u* - (rho_f/rho) grad phi the divergence is the residual of the solver over dx.
/// The solver is matrix-free CG, PETSc prefix pressure_. An assembled matrix serves preconditioners that need entries
/// (hypre, mg, gamg). Where the density is uniform, the default preconditioner, the transform, solves the equation
/// alone, unless -pressure_ksp_ options ask for CG.
template <int Dim>
class PressureSolver {
 public:
  /// Collective.
  explicit PressureSolver(const Grid<Dim>& grid);

  /// Sets the face densities [kg/m3] of this step; does nothing if they have not changed. With the fluid's share H on
  /// faces, the equation is that of (4.2-9), H/rho in place of 1/rho, H not below 1e-2. Collective.
  void set_density(Vec density, Vec fluid_fraction = nullptr);

  /// rho_f: the least of the densities set last [kg/m3].
  double reference_density() const { return reference_density_; }
  /// Whether `solve` is exact and needs no tolerance.
  bool is_direct() const { return solves_directly_ && is_uniform_; }

  /// Solves to a residual norm below `tolerance` [1/s]; `phi` contains a guess, then the solution; `minus_divergence`
  /// is overwritten. Returns the iterations. Collective. Errors: DivergedError.
  PetscInt solve(Vec minus_divergence, double tolerance, Vec phi);

  /// velocity -= (rho_f/rho) grad phi on all inner faces. Collective.
  void correct(Vec phi, Vec velocity) const;

 private:
  static PetscErrorCode multiply(Mat matrix, Vec x, Vec y);
  void apply(Vec x, Vec y);
  void solve_directly(Vec minus_divergence, Vec phi) const;
  void create_matrices();
  bool find_ratio(Vec density, Vec fluid_fraction);
  void close_boundary_faces();
  template <class Ratio>
  void correct_by(const Ratio& ratio, Vec phi, Vec velocity) const;
  void assemble();
  void set_preconditioner_defaults();

  const Grid<Dim>& grid_;
  double reference_density_ = 1;
  petsc::Vector ratio_;      ///< rho_f/rho, or H rho_f/rho, on faces, local, 0 on boundary faces; null if not needed
  petsc::Vector local_phi_;  ///< ghosted; ghosts beyond the boundary stay 0
  petsc::Matrix matrix_;
  petsc::Matrix assembled_;  ///< assembled matrix; null if the preconditioner needs none
  petsc::NullSpace constants_;
  petsc::Solver solver_;
  bool user_sets_atol_ = false, solves_directly_ = false;
  bool is_uniform_ = false;                 ///< whether the density set last is uniform
  std::array<petsc::Version, 2> versions_;  ///< versions of density and H set last
  bool assembled_is_uniform_ = false;
};

extern template class PressureSolver<2>;
extern template class PressureSolver<3>;

}  // namespace washfsi
