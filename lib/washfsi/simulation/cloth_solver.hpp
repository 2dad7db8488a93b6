// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <functional>

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Solves for the velocities of all markers: a SNES with the options prefix cloth_, whose Jacobian, or the
/// preconditioner of it, is a sparse matrix of the cloths' lattice.
template <int Dim>
class ClothSolver {
 public:
  /// The equation's left side at given velocities, one value per marker of this rank. Collective.
  using Residual = std::function<Points<Dim>(const Points<Dim>& velocities)>;
  /// Adds its Jacobian, or something near it, to a matrix of zeros. Collective.
  using Assemble = std::function<void(const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix)>;

  /// A function whose gradient the residual is. Collective.
  using Potential = std::function<double(const Points<Dim>& velocities)>;
  /// The Jacobian, where the matrix was assembled last, times a direction. Collective.
  using Product = std::function<Points<Dim>(const Points<Dim>& direction)>;

  /// An equation for the velocities. Newton's steps are shortened until they lower the potential or the residual;
  /// without a potential, the preconditioned residual. Far from the solution the matrix of one with a potential leaves
  /// the geometric stiffness of compressed edges out, so that they can.
  struct Equation {
    Residual residual;
    Assemble assemble;
    double round_off = 0;  ///< 2-norm over all markers that its residual may have at the solution
    Potential potential = {};
    Product product = {};  ///< if the assembled matrix only preconditions; else by differences of the residual
  };

  /// What is solved unless the user chooses otherwise.
  struct Defaults {
    SNESType type;   ///< newtonls: the matrix is the Jacobian; qn: it is where the quasi-Newton matrix starts from
    bool symmetric;  ///< whether the matrix is symmetric positive definite: Cholesky instead of LU
    bool approximate = false;  ///< newtonls: the matrix only preconditions the Jacobian, the equation's `product`
  };
  /// `positions` are any that the cloths may have. Collective. Errors: InputError.
  ClothSolver(const Cloths<Dim>& cloths, const Points<Dim>& positions, const Defaults& defaults);
  ClothSolver(const ClothSolver&) = delete;
  ClothSolver& operator=(const ClothSolver&) = delete;

  /// Solves an equation until the 2-norm of its residual over all markers is below `tolerance`, or round-off;
  /// `velocities` holds a guess, then the solution. Returns the number of evaluations of the residual. Collective.
  /// Errors: DivergedError.
  PetscInt solve(const Equation& equation, double tolerance, Points<Dim>& velocities);

 private:
  static PetscErrorCode evaluate(SNES solver, Vec x, Vec f, void* self);
  static PetscErrorCode test_convergence(SNES solver, PetscInt iteration, PetscReal unknown, PetscReal step,
                                         PetscReal residual, SNESConvergedReason* reason, void* self);
  static PetscErrorCode multiply(Mat jacobian, Vec x, Vec y);
  double preconditioned_norm(Vec f, Vec work) const;
  double slope_towards_descent(Vec x, Vec f, Vec direction);
  static PetscErrorCode shorten(SNESLineSearch search, void* self);
  static PetscErrorCode linearise(SNES solver, Vec x, Mat jacobian, Mat preconditioner, void* self);
  void set_up_linear_solver(const Points<Dim>& positions);
  void set_default_solvers(const Defaults& defaults);
  bool applies_matrix_free() const;
  void forget_last_solve();
  void aim_at(double residual);

  const Cloths<Dim>& cloths_;
  petsc::NonlinearSolver solver_;
  petsc::Matrix matrix_, matrix_free_;
  petsc::Vector unknown_, value_;
  const Equation* equation_ = nullptr;  ///< during `solve`
  GeometricStiffness geometric_ = GeometricStiffness::of_tension;
  bool is_round_off_ = false;   ///< whether the last step's preconditioned residual was no more
  std::exception_ptr failure_;  ///< of the physics, thrown in a callback: it must not cross PETSc's frames
  PetscInt evaluations_ = 0;
  bool user_sets_atol_ = false, solves_linearly_ = false, approximate_ = false, aims_linear_solver_ = false;
};

extern template class ClothSolver<2>;
extern template class ClothSolver<3>;

}  // namespace washfsi
