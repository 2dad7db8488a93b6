// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include <mpi.h>

#include "washfsi/immersed_boundary/kernel_moments.hpp"
#include "washfsi/mask/inner_water.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Mean distance of markers in the middle of thin parts [cells].
template <int Dim>
constexpr double sheet_mean_spacing = Dim == 2 ? 0.65 : 0.38;

/// The parameters of a layout of markers on a surface.
template <int Dim>
struct MarkerLayout {
  Point<Dim> cell;                  ///< the grid's spacing [m]
  double spacing = 1.0;             ///< least distance of patches: 1.2 times on sheets, 1.3 on solids [cells]
  KernelMoments moments;            ///< moments of the markers' delta
  bool inner_water_slides = false;  ///< whether water within bodies, and all at thin parts, slides along the walls
  Point<Dim> period = Point<Dim>::Zero();  ///< surface's period where it repeats after the region, else 0
  InnerWater inside = {false, std::numeric_limits<double>::infinity()};  ///< water inside the body
  MPI_Comm comm = MPI_COMM_SELF;  ///< ranks that share the work; all get all markers
};

}  // namespace washfsi
