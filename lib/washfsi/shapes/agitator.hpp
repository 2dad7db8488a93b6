// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// The agitator of a washing machine with a vertical axis, standing on z = 0: a low dome, curved vanes on it, and a
/// post in its middle with a half sphere on top. The thesis gives the symmetry, the post's radius and that the vanes'
/// plan is a polynomial; all other dimensions are our own, for its drawing is not available. Lengths in metres.
struct AgitatorDimensions {
  double post_radius = 0.0275, post_height = 0.19;  ///< the height is that of the top of the half sphere
  double dome_radius = 0.17, dome_height = 0.02;    ///< a paraboloid
  double tip_radius = 0.16;                         ///< reach of the vanes from the axis
  double vane_height = 0.055;                       ///< height of their round tops above z = 0
  double vane_thickness = 0.025;
  int vanes = 3;
  /// Plan of the first vane: y = R (c1 x/R + c2 (x/R)^2 + c3 (x/R)^3) with R the tip's radius; it bends to the left.
  double curve[3] = {0, 0.4, 0};
};

/// The agitator with its exact distance outside.
ShapePtr<3> agitator(const AgitatorDimensions& dimensions);

/// The agitator sampled on a lattice of this spacing, which is much faster. Collective.
ShapePtr<3> sampled_agitator(MPI_Comm comm, const AgitatorDimensions& dimensions, double spacing,
                             const std::string& name);

}  // namespace washfsi
