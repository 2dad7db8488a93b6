// SPDX-License-Identifier: BSD-3-Clause
//
// How much of the force on one marker reaches another through the faces of the grid, away from the sides of the box.
#pragma once

#include <algorithm>
#include <cmath>

#include "washfsi/immersed_boundary/face_stencil.hpp"

namespace washfsi {

/// Sum of the products of two markers' weights along one axis, with all periodic images.
template <int Dim, class A, class B>
double axis_overlap(const Grid<Dim>& grid, int axis, const A& a, const B& b) {
  const auto with_shift = [&](PetscInt shift) {
    double sum = 0;
    for (PetscInt i = std::max<PetscInt>(0, shift); i < std::min<PetscInt>(a.count, b.count + shift); ++i)
      sum += a.weight[i] * b.weight[i - shift];
    return sum;
  };
  PetscInt shift = b.first - a.first;
  if (!grid.periodic(axis)) return with_shift(shift);
  const PetscInt cells = grid.cells()[axis];
  shift -= cells * static_cast<PetscInt>(std::llround(static_cast<double>(shift) / static_cast<double>(cells)));
  const double nearest = with_shift(shift);
  return cells >= a.count + b.count ? nearest : nearest + with_shift(shift - cells) + with_shift(shift + cells);
}

/// J S of one marker on another, for each component, per cell volume.
template <int Dim, class A, class B>
Point<Dim> overlap(const Grid<Dim>& grid, const FaceStencil<Dim, A>& moved, const FaceStencil<Dim, B>& pushed) {
  Point<Dim> result = Point<Dim>::Ones();
  for (int d = 0; d < Dim; ++d) {
    const auto along = [&](int component) {
      return axis_overlap<Dim>(grid, d, moved.along(d, component), pushed.along(d, component));
    };
    const double normal = along(d), between = along((d + 1) % Dim);
    for (int c = 0; c < Dim; ++c) result[c] *= c == d ? normal : between;
    if (normal == 0 && between == 0) break;
  }
  return result;
}

}  // namespace washfsi
