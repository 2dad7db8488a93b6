// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/marker_layout/body_markers.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// A point where the law of the wall is evaluated: on one face of a patch of markers. Thin parts have two.
template <int Dim>
struct WallPoint {
  std::size_t body, patch;  ///< body, and patch counted over all bodies
  Point<Dim> foot, normal;  ///< place on the surface [m] and outward normal, in the body's frame
  double along;             ///< a cell's size in the normal's direction [m]
  bool is_thick;            ///< whether the body is at least two cells deep behind it
  bool in_sheet;  ///< whether it is on a thin part: then the point before or after it in the list is on the other face
  bool at_edge;   ///< whether the patch bends round an edge: no slip there instead of the law, so that the layer
                  ///< separates
  double area = 0;  ///< area of the surface nearest to it [m2; m in the plane]
};

/// Returns one or two points per patch, in the patches' order. A corner has no wall layer: there is no point where the
/// place `clear` cells before it is nearer to the body than half of that.
template <int Dim>
std::vector<WallPoint<Dim>> wall_points(const std::vector<Body<Dim>>& bodies, const BodyMarkers<Dim>& markers,
                                        const Point<Dim>& cell, double clear);

}  // namespace washfsi
