// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/marker_layout/body_markers.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// Where the law of a wall layer is asked: on one face of a patch of markers. Thin parts have two.
template <int Dim>
struct WallPoint {
  std::size_t body, patch;  ///< the latter of all bodies' patches
  Point<Dim> foot, normal;  ///< on the surface [m], and out of it; in the body's frame
  double along;             ///< a cell's size in the normal's direction [m]
  bool is_thick;            ///< the body goes on behind it for two cells
  bool in_sheet;            ///< of a thin part: the point before or after it in their order is on the other face
  bool at_edge;             ///< the patch bends round an edge: no law, markers hold all there, so that layers part
  double area = 0;          ///< of the surface that is nearest to it [m2; m in the plane]
};

/// One or two of each patch, in their order. In a corner there is no layer: where the body is nearer to what lies
/// `clear` cells before the point than half of that, there is none.
template <int Dim>
std::vector<WallPoint<Dim>> wall_points(const std::vector<Body<Dim>>& bodies, const BodyMarkers<Dim>& markers,
                                        const Point<Dim>& cell, double clear);

}  // namespace washfsi
