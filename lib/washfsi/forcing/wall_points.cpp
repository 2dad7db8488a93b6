// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/wall_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/forcing/sheet_normal.hpp"
#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

namespace {

/// Finds the faces of one shape beside the middles of patches.
template <int Dim>
class FaceFinder {
 public:
  FaceFinder(const Shape<Dim>& shape, const Point<Dim>& cell) : shape_(shape), cell_(cell.minCoeff()) {}

  // Out of the shape from a place on its surface, or from the middle of a thin part, where the distance is a ridge.
  Points<Dim> ways_out(const Point<Dim>& place) const {
    constexpr double steepest_ridge = 0.7;
    const Point<Dim> slope = distance_gradient<Dim>(shape_, place, 0.5 * cell_);
    if (slope.norm() > steepest_ridge) return {slope.normalized()};
    const Point<Dim> across = sheet_normal<Dim>(shape_, place, cell_);
    return {across, -across};
  }

  // Where a way leads out of the shape, by Newton's method along it; where it began if it does not.
  Point<Dim> surface(const Point<Dim>& place, const Point<Dim>& way) const {
    Point<Dim> foot = place;
    for (int n = 0; n < 4; ++n) foot -= shape_.distance(foot) * way;
    return std::abs(shape_.distance(foot)) < 0.1 * cell_ ? foot : place;
  }

 private:
  const Shape<Dim>& shape_;
  double cell_;
};

// One over the density of points of the same face round each, by a Gaussian in cells.
template <int Dim>
void find_areas(std::vector<WallPoint<Dim>>& points, const Point<Dim>& cell) {
  constexpr double width = 1.5, reach = 3 * width;
  if (points.empty()) return;
  std::vector<Bounds<Dim>> bounds;
  for (const auto& point : points) bounds.push_back(Bounds<Dim>::round(point.foot, Point<Dim>::Zero()));
  Bounds<Dim> all = bounds.front();
  for (const auto& one : bounds) all.include(one);
  const NearSearch<Dim> search(bounds, cell, all);
  const double peak = std::pow(2 * std::numbers::pi * width * width, -0.5 * (Dim - 1));
  for (auto& point : points) {
    double density = 0;
    for (const std::size_t other : search.near(Bounds<Dim>::round(point.foot, reach * cell)))
      if (points[other].body == point.body && points[other].normal.dot(point.normal) > 0.5)
        density += peak * std::exp(-0.5 * (points[other].foot - point.foot).cwiseQuotient(width * cell).squaredNorm());
    point.area = cell.prod() / point.along / density;
  }
}

}  // namespace

template <int Dim>
std::vector<WallPoint<Dim>> wall_points(const std::vector<Body<Dim>>& bodies, const BodyMarkers<Dim>& markers,
                                        const Point<Dim>& cell, double clear) {
  std::vector<WallPoint<Dim>> points;
  std::size_t first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Shape<Dim>& shape = *bodies[b].shape;
    const FaceFinder<Dim> faces(shape, cell);
    const MarkerPatches<Dim>& patches = markers.of_body(b);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      Point<Dim> middle = Point<Dim>::Zero();
      for (std::size_t m = patches.starts[p]; m < patches.starts[p + 1]; ++m) middle += patches.feet[m];
      middle /= static_cast<double>(patches.starts[p + 1] - patches.starts[p]);
      for (const Point<Dim>& normal : faces.ways_out(middle)) {
        const double along = normal.cwiseProduct(cell).norm();
        const Point<Dim> foot = faces.surface(middle, normal);
        if (shape.distance(foot + clear * along * normal) >= 0.5 * clear * along)
          points.push_back(
              {b, first + p, foot, normal, along, shape.distance(foot - 2 * along * normal) < -1.5 * along});
      }
    }
    first += patches.size();
  }
  find_areas<Dim>(points, cell);
  return points;
}

template std::vector<WallPoint<2>> wall_points(const std::vector<Body<2>>&, const BodyMarkers<2>&, const Point<2>&,
                                               double);
template std::vector<WallPoint<3>> wall_points(const std::vector<Body<3>>&, const BodyMarkers<3>&, const Point<3>&,
                                               double);

}  // namespace washfsi
