// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest points of segments and triangles.
#pragma once

#include <array>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// The way to a place from the nearest point of a segment, which may be a point.
template <int Dim>
Point<Dim> way_from_segment(const Point<Dim>& from, const Point<Dim>& along, const Point<Dim>& place) {
  const Point<Dim> arm = place - from;
  const double length2 = along.squaredNorm();
  const double part = length2 > 0 ? std::clamp(arm.dot(along) / length2, 0.0, 1.0) : 0;
  return arm - part * along;
}

/// The corners of a triangle in space [m].
using Triangle = std::array<Point<3>, 3>;

/// Twice its area, along its normal.
inline Point<3> area_normal(const Triangle& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

/// The nearest part of a triangle: its face, or the edge from corner `index` to the next, or this corner.
enum class TrianglePart { face, edge, corner };
struct NearestOnTriangle {
  Point<3> place;  ///< [m]
  TrianglePart part;
  std::size_t index;
};

/// The point of a triangle that is nearest to a place. The triangle must have an area.
NearestOnTriangle nearest_on(const Triangle& triangle, const Point<3>& place);

}  // namespace washfsi
