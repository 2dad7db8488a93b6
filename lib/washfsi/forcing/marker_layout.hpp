// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "washfsi/body/inner_water.hpp"
#include "washfsi/forcing/kernel_moments.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// How markers are laid on a surface.
template <int Dim>
struct MarkerLayout {
  Point<Dim> cell;                  ///< the grid's spacing [m]
  double spacing = 1.0;             ///< mean width of a patch on a sheet [cells]; solids have wider ones
  KernelMoments moments;            ///< of the delta by which they act
  bool inner_water_slides = false;  ///< that within bodies, and all at thin parts, along the walls
  InnerWater inside = {false, std::numeric_limits<double>::infinity()};  ///< of the body
};

}  // namespace washfsi
