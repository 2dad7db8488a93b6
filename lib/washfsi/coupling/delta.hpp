// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// Half widths of the regularised delta in cells.
struct DeltaOptions {
  double spread_width = 2, interpolate_width = 2;

  static DeltaOptions from_options(Options& options);
};

/// h phi(x; eps) with x and eps in cells: (1 + cos(pi x / eps)) / (2 eps) for |x| < eps, else 0 (3.4-5). For 2 eps a
/// whole number its sum over unit steps is 1 wherever they start.
inline double cosine_delta(double distance, double width) {
  if (std::abs(distance) >= width) return 0;
  return (1 + std::cos(std::numbers::pi * distance / width)) / (2 * width);
}

/// The grid points that one marker reaches along one axis, with their weights.
struct AxisStencil {
  static constexpr int most = 8;  ///< points within a half width of 4 cells
  PetscInt first = 0;
  int count = 0;
  std::array<double, most> weight{};
};

/// `coordinate`: of the marker, in cells from the first grid point of the axis.
inline AxisStencil axis_stencil(double coordinate, double width) {
  AxisStencil stencil;
  stencil.first = static_cast<PetscInt>(std::floor(coordinate - width)) + 1;
  for (PetscInt i = stencil.first; static_cast<double>(i) < coordinate + width && stencil.count < AxisStencil::most;
       ++i)
    stencil.weight[static_cast<std::size_t>(stencil.count++)] =
        cosine_delta(static_cast<double>(i) - coordinate, width);
  return stencil;
}

}  // namespace washfsi
