// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/geometry/nearest.hpp"

#include <limits>

namespace washfsi {

namespace {

bool projects_inside(const Triangle& t, const Point<3>& normal, const Point<3>& place) {
  for (std::size_t k = 0; k < 3; ++k)
    if (normal.dot((t[(k + 1) % 3] - t[k]).cross(place - t[k])) < 0) return false;
  return true;
}

}  // namespace

NearestOnTriangle nearest_on(const Triangle& t, const Point<3>& place) {
  const Point<3> normal = area_normal(t);
  if (projects_inside(t, normal, place))
    return {place - normal.dot(place - t[0]) / normal.squaredNorm() * normal, TrianglePart::face, 0};
  NearestOnTriangle nearest{t[0], TrianglePart::corner, 0};
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < 3; ++k) {
    const Point<3> edge = t[(k + 1) % 3] - t[k];
    const double along = std::clamp((place - t[k]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const Point<3> foot = t[k] + along * edge;
    if ((place - foot).squaredNorm() >= least) continue;
    least = (place - foot).squaredNorm();
    const bool inner = along > 0 && along < 1;
    nearest = {foot, inner ? TrianglePart::edge : TrianglePart::corner, along < 1 ? k : (k + 1) % 3};
  }
  return nearest;
}

}  // namespace washfsi
