// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include <mpi.h>

#include "washfsi/marker_layout/kernel_moments.hpp"
#include "washfsi/mask/inner_water.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Mean distance of markers in the middle of thin parts [cells].
template <int Dim>
constexpr double sheet_mean_spacing = Dim == 2 ? 0.65 : 0.38;

/// How markers are laid on a surface.
template <int Dim>
struct MarkerLayout {
  Point<Dim> cell;                         ///< the grid's spacing [m]
  double spacing = 1.0;                    ///< width of patches: 1.2 times on sheets, 1.8 on solids [cells]
  KernelMoments moments;                   ///< of the delta by which they act
  bool inner_water_slides = false;         ///< that within bodies, and all at thin parts, along the walls
  Point<Dim> period = Point<Dim>::Zero();  ///< along axes on which the surface repeats itself after the region, else 0
  InnerWater inside = {false, std::numeric_limits<double>::infinity()};  ///< of the body
  MPI_Comm comm = MPI_COMM_SELF;  ///< of the ranks that share the work, and all get all markers
};

}  // namespace washfsi
