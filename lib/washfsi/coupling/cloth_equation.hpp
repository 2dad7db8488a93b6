// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// An equation for one vector of each marker, its velocity or a force. All of its functions are collective and take
/// this rank's part.
template <int Dim>
struct ClothEquation {
  /// Its left side, one value per marker.
  std::function<Points<Dim>(const Points<Dim>& velocities)> residual;
  /// Sets a matrix to its Jacobian, or to something near it.
  std::function<void(const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix)> assemble;
  double round_off = 0;  ///< 2-norm over all markers that its residual may have at the solution
  /// A function whose gradient the residual is, if there is one.
  std::function<double(const Points<Dim>& velocities)> potential = {};
  /// The Jacobian, where the matrix was assembled last, times a direction: if the matrix only preconditions; else that
  /// is found by differences of the residual.
  std::function<Points<Dim>(const Points<Dim>& direction)> product = {};
  /// How fast the potential grows along a direction; if there is none, as the residual, its gradient, has it.
  std::function<double(const Points<Dim>& residual, const Points<Dim>& direction)> slope = {};
  /// The part of a way that can be gone without coming to what limits the motion, from 0 to 1; if there is none, all.
  std::function<double(const Points<Dim>& from, const Points<Dim>& way)> step_limit = {};
  /// Whether a residual is small enough; if there is none, its 2-norm tells.
  std::function<bool(const Points<Dim>& residual)> is_solved = {};
};

}  // namespace washfsi
