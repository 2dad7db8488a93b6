// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

struct VanedDimensions {
  double hub_radius = 0.07;      ///< [m]
  double tip_radius = 0.19;      ///< reach of the vanes from the centre [m]
  double vane_thickness = 0.04;  ///< [m]; the tips are half circles
  int vanes = 3;
};

/// A hub with equal rounded vanes: the union of a circle and of capsules from the centre outwards, the first vane
/// along x. The geometry is our own; the thesis's drawing is not available.
ShapePtr<2> vaned(const VanedDimensions& dimensions);

}  // namespace washfsi
