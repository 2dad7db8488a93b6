// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace washfsi {

Polygon::Polygon(Points<2> vertices, Kind kind) {
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Point<2>&from = vertices[k], &to = vertices[(k + 1) % vertices.size()];
    const bool on_axis = kind == Kind::profile && from[0] == 0 && to[0] == 0;
    edges_.push_back({from, to - from, 1 / (to - from).squaredNorm(), !on_axis});
  }
}

double Polygon::distance(const Point<2>& place) const {
  double nearest2 = std::numeric_limits<double>::max();
  bool inside = false;
  for (const Edge& edge : edges_) {
    const Point<2> arm = place - edge.from;
    if (edge.is_surface) {
      const double along = std::clamp(arm.dot(edge.along) * edge.inverse_length2, 0.0, 1.0);
      nearest2 = std::min(nearest2, (arm - along * edge.along).squaredNorm());
    }
    // a ray towards +x crosses the outline an odd number of times from inside
    const bool spans = (arm[1] >= 0) != (arm[1] - edge.along[1] >= 0);
    if (spans && arm[0] < edge.along[0] * arm[1] / edge.along[1]) inside = !inside;
  }
  return (inside ? -1 : 1) * std::sqrt(nearest2);
}

Extent<2> Polygon::extent() const {
  Bounds<2> bounds{edges_.front().from, edges_.front().from};
  for (const Edge& edge : edges_) bounds.include({edge.from, edge.from});
  return {bounds};
}

namespace {

double cross_product(const Point<2>& a, const Point<2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

// Whether segments a-b and c-d have a point in common.
bool meet(const Point<2>& a, const Point<2>& b, const Point<2>& c, const Point<2>& d) {
  const auto side = [](const Point<2>& from, const Point<2>& to, const Point<2>& point) {
    const double area = cross_product(to - from, point - from);
    return (area > 0) - (area < 0);
  };
  const auto between = [](const Point<2>& from, const Point<2>& to, const Point<2>& point) {
    return (point - from).dot(point - to) <= 0;
  };
  const int c_side = side(a, b, c), d_side = side(a, b, d), a_side = side(c, d, a), b_side = side(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && between(a, b, c)) || (d_side == 0 && between(a, b, d)) || (a_side == 0 && between(c, d, a)) ||
         (b_side == 0 && between(c, d, b));
}

// Whether the edges a-b and b-c lie on each other.
bool folds_back(const Point<2>& a, const Point<2>& b, const Point<2>& c) {
  return cross_product(a - b, c - b) == 0 && (a - b).dot(c - b) > 0;
}

bool crosses_itself(const Points<2>& vertices) {
  const std::size_t n = vertices.size();
  const auto vertex = [&](std::size_t k) { return vertices[k % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (folds_back(vertex(i), vertex(i + 1), vertex(i + 2))) return true;
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && meet(vertex(i), vertex(i + 1), vertex(j), vertex(j + 1))) return true;
  }
  return false;
}

}  // namespace

std::string Polygon::flaw(const Points<2>& vertices) {
  const std::size_t n = vertices.size();
  if (n < 3) return "it has fewer than 3 corners";
  double area = 0, extent = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (vertices[k] == vertices[(k + 1) % n]) return "two corners in a row are the same";
    area += 0.5 * cross_product(vertices[k] - vertices[0], vertices[(k + 1) % n] - vertices[0]);
    extent = std::max(extent, (vertices[k] - vertices[0]).squaredNorm());
  }
  if (std::abs(area) <= 1e-12 * extent) return "its area is 0";
  if (crosses_itself(vertices)) return "its edges cross or touch each other";
  return "";
}

}  // namespace washfsi
