// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/cloth_equation.hpp"

namespace washfsi {

/// The line search of Newton's method for the cloth: the whole of a step, or a half, a quarter ... of it, the first
/// that lowers the potential or, near the solution, where differences of the potential drown in round-off, the
/// residual; without a potential, the preconditioned residual (Deuflhard's natural level function, with the
/// preconditioner in place of the Jacobian: a residual's own norm sees little but the stiffest waves). The matrix
/// omits the geometric stiffness of compressed edges, so that such a step exists: with a potential only far from the
/// solution, without one always, since GMRES hardly solves indefinite systems. Where something limits the motion, the
/// first step tried is shortened to the step limit.
template <int Dim>
class DescentSearch {
 public:
  DescentSearch() = default;
  DescentSearch(const DescentSearch&) = delete;
  DescentSearch& operator=(const DescentSearch&) = delete;

  /// Becomes the line search of a solver, whose Jacobian, or its preconditioner, is `matrix`. Both must outlive it.
  void attach(SNES solver, Mat matrix);
  /// Call it before each solution.
  void start(const ClothEquation<Dim>& equation);

  /// How much of the geometric stiffness the next matrix is to contain.
  GeometricStiffness geometric() const { return geometric_; }
  /// Whether the preconditioned residual after the last step is only round-off.
  bool is_round_off() const { return is_round_off_; }
  /// Whether the last step, in an equation with a step limit, was only a part of Newton's: then a short step is no sign
  /// that the solution is near.
  bool was_stopped() const { return was_stopped_; }

 private:
  static PetscErrorCode shorten(SNESLineSearch search, void* self);
  void search(SNESLineSearch search);
  double lowest_part(Vec x, Vec direction, double part, Vec trial, Vec f);
  void accept(SNESLineSearch search, double part);
  double potential_at(Vec place) const;
  double size_of(Vec residual, Vec work) const;
  double slope_towards_descent(Vec x, Vec f, Vec direction);
  double slope_of_exact_step(Vec f, Vec direction);
  double lengthened(Vec x, Vec direction, double slope, double before, Vec trial, Vec f);
  bool is_free(Vec from, Vec to) const;
  double slope_along(Vec f, Vec direction) const;
  double step_limit(Vec x, Vec direction) const;
  KSP linear_solver() const;

  SNES solver_ = nullptr;
  Mat matrix_ = nullptr;
  const ClothEquation<Dim>* equation_ = nullptr;  ///< set during a solution
  GeometricStiffness geometric_ = GeometricStiffness::of_tension;
  bool is_round_off_ = false, was_stopped_ = false;
};

extern template class DescentSearch<2>;
extern template class DescentSearch<3>;

}  // namespace washfsi
