// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "washfsi/cloth/forces.hpp"
#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// An equation for one vector per marker, its velocity or a force. All of its functions are collective and take this
/// rank's part.
template <int Dim>
struct ClothEquation {
  /// The residual of the equation, one vector per marker.
  std::function<Points<Dim>(const Points<Dim>& velocities)> residual;
  /// Sets a matrix to the residual's Jacobian or an approximation of it.
  std::function<void(const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix)> assemble;
  double round_off = 0;  ///< 2-norm over all markers of the residual's round-off at the solution
  /// The potential whose gradient the residual is, if there is one.
  std::function<double(const Points<Dim>& velocities)> potential = {};
  /// The Jacobian, where the matrix was assembled last, times a direction, for a matrix that only preconditions;
  /// without it the product is found by differences of the residual.
  std::function<Points<Dim>(const Points<Dim>& direction)> product = {};
  /// The slope of the potential along a direction; by default the product of residual and direction.
  std::function<double(const Points<Dim>& residual, const Points<Dim>& direction)> slope = {};
  /// The step limit: the share of a motion, from 0 to 1, that nothing limits; by default 1.
  std::function<double(const Points<Dim>& from, const Points<Dim>& way)> step_limit = {};
  /// Whether a residual is small enough; by default its 2-norm decides.
  std::function<bool(const Points<Dim>& residual)> is_solved = {};
};

/// Solves a step, and again while its forces are sharpened at the solution, a few times at most. solve() returns the
/// places of this rank's markers at the solution. Collective.
template <int Dim, class Solve>
void solve_sharply(Forces<Dim>& forces, const Solve& solve) {
  constexpr int most_sharpenings = 8;
  for (int left = most_sharpenings;; --left) {
    const Points<Dim> places = solve();
    if (left == 0 || !forces.sharpen(places)) return;
  }
}

}  // namespace washfsi
