// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_law/wall_points.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "washfsi/geometry/near_search.hpp"
#include "washfsi/grid/subdivide.hpp"
#include "washfsi/marker_layout/sheet_normal.hpp"

namespace washfsi {

namespace {

/// Finds the faces of one shape beside the middles of patches.
template <int Dim>
class FaceFinder {
 public:
  FaceFinder(const Shape<Dim>& shape, const Point<Dim>& cell) : shape_(shape), cell_(cell), least_(cell.minCoeff()) {}

  struct Origin {
    std::size_t body, patch;
  };
  // Adds the points of a patch; `of` is their origin.
  void add_points(const MarkerPatches<Dim>& patches, std::size_t p, double clear, Origin of,
                  std::vector<WallPoint<Dim>>& points) const {
    const Point<Dim> middle = patches.middle(p);
    const bool in_sheet = patches.is_in_sheet(p);
    const std::span feet(&patches.feet[patches.starts[p]], patches.starts[p + 1] - patches.starts[p]);
    for (const Point<Dim>& normal : ways_out(middle, in_sheet)) {
      const double along = normal.cwiseProduct(cell_).norm();
      const Point<Dim> foot = surface(middle, normal);
      if (shape_.distance(foot + clear * along * normal) < 0.5 * clear * along) continue;
      const bool is_thick = shape_.distance(foot - 2 * along * normal) < -1.5 * along;
      points.push_back({of.body, of.patch, foot, normal, along, is_thick, in_sheet, !in_sheet && bends(feet, normal)});
    }
  }

 private:
  // Directions out of the shape from a place on its surface, or from the middle of a thin part, a ridge of the
  // distance.
  Points<Dim> ways_out(const Point<Dim>& place, bool in_sheet) const {
    constexpr double steepest_ridge = 0.7;
    const Point<Dim> slope = distance_gradient<Dim>(shape_, place, 0.5 * least_);
    if (!in_sheet && slope.norm() > steepest_ridge) return {slope.normalized()};
    const Point<Dim> across = sheet_normal<Dim>(shape_, place, cell_);
    return {across, -across};
  }

  // Whether a patch of markers bends away from the normal of one of its faces.
  bool bends(std::span<const Point<Dim>> feet, const Point<Dim>& normal) const {
    constexpr double least = 0.8;  // least dot product of the normals
    return std::any_of(feet.begin(), feet.end(), [&](const Point<Dim>& foot) {
      return std::abs(distance_gradient<Dim>(shape_, foot, 0.05 * least_).dot(normal)) < least;
    });
  }

  // Where a way leaves the shape, by Newton's method along it; its start if it does not.
  Point<Dim> surface(const Point<Dim>& place, const Point<Dim>& way) const {
    Point<Dim> foot = place;
    for (int n = 0; n < 4; ++n) foot -= shape_.distance(foot) * way;
    return std::abs(shape_.distance(foot)) < 0.1 * least_ ? foot : place;
  }

  const Shape<Dim>& shape_;
  const Point<Dim>& cell_;
  double least_;
};

/// Cells of a lattice in a body's frame within a region, finer than the grid's by a factor.
template <int Dim>
struct FineCells {
  FineCells(const Bounds<Dim>& region, const Point<Dim>& cell, int to_each) : corner(region.lower) {
    for (int d = 0; d < Dim; ++d) {
      const double length = region.upper[d] - region.lower[d];
      box.lower[d] = 0;
      box.upper[d] = std::max<PetscInt>(1, std::lround(to_each * length / cell[d]));
      size[d] = length / static_cast<double>(box.upper[d]);
    }
  }
  const Point<Dim>& lower() const { return corner; }
  const Point<Dim>& spacing() const { return size; }
  Point<Dim> center(const Index<Dim>& cell) const {
    Point<Dim> place;
    for (int d = 0; d < Dim; ++d) place[d] = corner[d] + (static_cast<double>(cell[d]) + 0.5) * size[d];
    return place;
  }

  Point<Dim> corner, size;
  Box<Dim> box{};
};

/// Distributes a body's surface over the points on it, each part to the nearest point on the same face, by the volume
/// of fine cells in a layer round the surface. So the areas of the points sum up to that of the surface within the
/// region. In a part thinner than the layer, this lies round the part's middle and counts for both faces.
template <int Dim>
class AreaFinder {
 public:
  AreaFinder(const Shape<Dim>& shape, const Bounds<Dim>& region, const Point<Dim>& cell,
             std::span<WallPoint<Dim>> points)
      : shape_(shape), cell_(cell), cells_(region, cell, to_each), points_(points), search_(search_of(points, cell)) {}

  void share_out() {
    const auto distance = [&](const Point<Dim>& place) { return shape_.distance(place); };
    subdivide<Dim>(
        cells_, cells_.box, layer * cell_.maxCoeff(), distance, [](const Box<Dim>&, int) {},
        [&](const Index<Dim>& cell) { give(cells_.center(cell)); });
  }

 private:
  static constexpr int to_each = 4;          // with `layer` the same share of cells wherever a flat face lies
  static constexpr double layer = 0.5;       // [cells]
  static constexpr double same_face = 0.9;   // least dot product of two normals on the same face
  static constexpr double round_edge = 0.6;  // the same before an edge
  static constexpr double farthest = 2;      // from a point [cells]: farther off is a corner without points

  static NearSearch<Dim> search_of(std::span<WallPoint<Dim>> points, const Point<Dim>& cell) {
    Points<Dim> feet;
    for (const auto& point : points) feet.push_back(point.foot);
    const auto bounds = bounds_of(feet);
    Bounds<Dim> asked = hull(bounds);
    asked.include({asked.lower - farthest * cell, asked.upper + farthest * cell});
    return {bounds, cell, asked};
  }

  void give(const Point<Dim>& place) {
    const double distance = shape_.distance(place);
    if (std::abs(distance) > layer * cell_.maxCoeff()) return;
    const Point<Dim> out = distance_gradient<Dim>(shape_, place, 1e-3 * cell_.minCoeff()).normalized();
    const double thickness = layer * out.cwiseProduct(cell_).norm();
    WallPoint<Dim>* point = std::abs(distance) < thickness ? point_for(place, out, distance) : nullptr;
    if (!point) return;
    WallPoint<Dim>* other = point->in_sheet ? other_face(point) : nullptr;
    if (other && (point->foot - other->foot).norm() > 2 * thickness) other = nullptr;
    const double away = other ? (place - 0.5 * (point->foot + other->foot)).dot(point->normal) : distance;
    const double area = std::max(0.0, 1 - std::abs(away) / thickness) * cells_.size.prod() / thickness;
    point->area += area;
    if (other) other->area += area;
  }

  // The point on the other face; null if it has none.
  WallPoint<Dim>* other_face(WallPoint<Dim>* point) const {
    const auto is_it = [&](const WallPoint<Dim>& candidate) { return candidate.patch == point->patch; };
    if (point > points_.data() && is_it(*(point - 1))) return point - 1;
    return point + 1 < points_.data() + points_.size() && is_it(*(point + 1)) ? point + 1 : nullptr;
  }

  // The point for a cell; before the edge of a solid, one on a face that meets there.
  WallPoint<Dim>* point_for(const Point<Dim>& place, const Point<Dim>& out, double distance) const {
    WallPoint<Dim>* point = nearest(place, out, same_face);
    if (point || distance <= 0) return point;
    point = nearest(place, out, round_edge);
    return point && !point->in_sheet ? point : nullptr;
  }

  // The nearest of the points whose normals have at least this dot product with `out`.
  WallPoint<Dim>* nearest(const Point<Dim>& place, const Point<Dim>& out, double alike) const {
    double least = farthest * farthest;
    WallPoint<Dim>* point = nullptr;
    search_.visit_near(Bounds<Dim>::round(place, farthest * cell_), [&](std::size_t p) {
      const double away = (points_[p].foot - place).cwiseQuotient(cell_).squaredNorm();
      if (away > least || points_[p].normal.dot(out) < alike) return;
      least = away;
      point = &points_[p];
    });
    return point;
  }

  const Shape<Dim>& shape_;
  const Point<Dim> cell_;
  FineCells<Dim> cells_;
  std::span<WallPoint<Dim>> points_;
  NearSearch<Dim> search_;
};

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
    const std::size_t of_body = points.size();
    for (std::size_t p = 0; p < patches.size(); ++p) faces.add_points(patches, p, clear, {b, first + p}, points);
    AreaFinder<Dim>(shape, markers.region(bodies[b]), cell, std::span(points).subspan(of_body)).share_out();
    first += patches.size();
  }
  return points;
}

template std::vector<WallPoint<2>> wall_points(const std::vector<Body<2>>&, const BodyMarkers<2>&, const Point<2>&,
                                               double);
template std::vector<WallPoint<3>> wall_points(const std::vector<Body<3>>&, const BodyMarkers<3>&, const Point<3>&,
                                               double);

}  // namespace washfsi
