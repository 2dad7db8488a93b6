// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/surface_markers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Eigenvalues>

#include "washfsi/body/subdivide.hpp"
#include "washfsi/forcing/even_spread.hpp"

namespace washfsi {

namespace {

template <int Dim>
constexpr double seeds_a_cell = Dim == 2 ? 8 : 2;
constexpr double markers_a_patch = 0.45;  // least distance of markers over that of patches
constexpr double edge_factor = 0.5;       // of the reach of a sheet, beyond its edges: as a face acts before itself
constexpr double smooth_bend = 0.1;       // in cells, above which a place belongs to an edge
constexpr double reach = 0.75;            // of the seeds from the surface [cells]

/// Cells of which each seeds one place of the surface; laid from the shape's origin, so that its markers do not depend
/// on where it is.
template <int Dim>
class SeedCells {
 public:
  SeedCells(const Bounds<Dim>& region, const Point<Dim>& cell) : spacing_(cell / seeds_a_cell<Dim>) {
    for (int d = 0; d < Dim; ++d) {
      box_.lower[d] = static_cast<PetscInt>(std::floor(region.lower[d] / spacing_[d])) - 1;
      box_.upper[d] = static_cast<PetscInt>(std::ceil(region.upper[d] / spacing_[d])) + 1;
    }
  }
  Point<Dim> lower() const { return Point<Dim>::Zero(); }
  const Point<Dim>& spacing() const { return spacing_; }
  const Box<Dim>& box() const { return box_; }
  Point<Dim> center(const Index<Dim>& cell) const {
    Point<Dim> place;
    for (int d = 0; d < Dim; ++d) place[d] = (static_cast<double>(cell[d]) + 0.5) * spacing_[d];
    return place;
  }

 private:
  Point<Dim> spacing_;
  Box<Dim> box_{};
};

/// Finds places on a surface and behind it.
template <int Dim>
class Sinker {
 public:
  Sinker(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout)
      : shape_(shape), layout_(layout), cell_(layout.cell.minCoeff()) {}

  std::optional<Candidate<Dim>> sink(const Point<Dim>& seed) const {
    const double from_surface = shape_.distance(seed);
    if (from_surface < 0 || from_surface > reach * layout_.cell.maxCoeff()) return {};
    const Point<Dim> out = gradient(seed, fine * cell_);
    const std::optional<Point<Dim>> foot = foot_of(seed);
    if (!foot || out.norm() < 0.5) return {};
    const Point<Dim> normal = out.normalized();
    const double along = normal.cwiseProduct(layout_.cell).norm();  // a cell's size in the normal's direction
    const auto [inmost, depth] = inmost_behind(*foot, normal, along);
    if (depth < along * layout_.moments.sheet_reach()) return in_sheet(inmost, normal);
    const double bend = bending(*foot), flat = along * layout_.moments.retraction(depth / along);
    // at an edge the way is that between its faces
    const Point<Dim> inwards = -gradient(*foot, coarse * cell_).normalized();
    return Candidate<Dim>{*foot + std::clamp(flat + bend, 0.0, depth) * inwards,
                          std::max(0.0, bend / cell_ - smooth_bend)};
  }

 private:
  static constexpr double fine = 0.05, coarse = 0.4;  // differences, in cells: of a surface, across ridges of the depth

  Point<Dim> gradient(const Point<Dim>& place, double step) const {
    Point<Dim> slope;
    for (int d = 0; d < Dim; ++d) {
      const Point<Dim> aside = step * Point<Dim>::Unit(d);
      slope[d] = (shape_.distance(place + aside) - shape_.distance(place - aside)) / (2 * step);
    }
    return slope;
  }

  // By Newton's method; nothing where the distance is no distance.
  std::optional<Point<Dim>> foot_of(const Point<Dim>& seed) const {
    Point<Dim> place = seed;
    for (int step = 0; step < 6; ++step) {
      const double distance = shape_.distance(place);
      if (std::abs(distance) < 1e-3 * cell_) return place;
      const Point<Dim> slope = gradient(place, fine * cell_);
      if (slope.norm() < 0.3) return {};
      place -= distance / slope.squaredNorm() * slope;
    }
    if (std::abs(shape_.distance(place)) < 0.02 * cell_) return place;
    return {};
  }

  // The place that is farthest from the surface on the way that leads from it fastest, and how far that is.
  std::pair<Point<Dim>, double> inmost_behind(const Point<Dim>& foot, const Point<Dim>& normal, double along) const {
    constexpr double farthest = 2;   // cells: what is deeper does not matter
    constexpr double slowest = 0.3;  // growth of the depth on its way: slower it runs along the middle of a sheet
    const double step = 0.1 * along;
    Point<Dim> inmost = foot, way = -normal;
    double depth = 0;
    for (int n = 0; n * step < farthest * along; ++n) {
      const Point<Dim> next = inmost + step * way;
      const double deeper = -shape_.distance(next);
      if (deeper <= depth + slowest * step) return {refined(inmost, way, step), std::max(depth, deeper)};
      inmost = next;
      depth = deeper;
      const Point<Dim> slope = gradient(inmost, coarse * cell_);
      if (slope.norm() > 0.1) way = -slope.normalized();
    }
    return {inmost, depth};
  }

  // Where between a place and the next step the depth is largest: the other side is as near there.
  Point<Dim> refined(const Point<Dim>& place, const Point<Dim>& way, double step) const {
    const double here = -shape_.distance(place), there = -shape_.distance(place + step * way);
    return place + std::clamp(0.5 * (step + there - here), 0.0, step) * way;
  }

  // A sheet of markers acts beyond its edges as it acts before its faces: a place nearer to an edge than that, or found
  // from the edge's own face, is moved to the outline that the sheet may fill, or to the middle of a narrower sheet.
  Candidate<Dim> in_sheet(Point<Dim> place, const Point<Dim>& out) const {
    place = centred(place, sheet_normal(place));  // beside its middle a sheet's normal is not sure
    const Point<Dim> normal = sheet_normal(place);
    place = centred(place, normal);
    const Point<Dim> along_sheet = out - out.dot(normal) * normal;
    bool moved = along_sheet.norm() > 0.7 && keep_within(place, along_sheet.normalized(), true);
    for (int sweep = 0; sweep < 2; ++sweep)
      for (const Point<Dim>& tangent : tangents(normal))
        for (const Point<Dim>& way : {tangent, Point<Dim>(-tangent)}) moved = keep_within(place, way, false) || moved;
    return {moved ? centred(place, normal) : place, moved ? 1.0 : 0.0};
  }

  // Moves a place back from an edge ahead, or from anywhere to it; whether it did.
  bool keep_within(Point<Dim>& place, const Point<Dim>& way, bool to_edge) const {
    const double along = way.cwiseProduct(layout_.cell).norm();
    const double sheet = edge_factor * along * layout_.moments.sheet_reach();
    const double ahead = extent(place, way, 2 * sheet, along);
    if (to_edge ? ahead == 2 * sheet : ahead >= sheet) return false;
    if (ahead >= sheet) {
      place += (ahead - sheet) * way;
      return true;
    }
    const double behind = extent(place, -way, 2 * sheet, along);
    place -= std::min(sheet - ahead, std::max(0.0, behind - ahead) / 2) * way;
    return true;
  }

  // Midway between the two faces of a sheet.
  Point<Dim> centred(const Point<Dim>& place, const Point<Dim>& normal) const {
    const double along = normal.cwiseProduct(layout_.cell).norm();
    return place + 0.5 * (extent(place, normal, along, along) - extent(place, -normal, along, along)) * normal;
  }

  // The direction in which one leaves a sheet soonest on both sides.
  Point<Dim> sheet_normal(const Point<Dim>& place) const {
    Eigen::Matrix<double, Dim, Dim> moments = Eigen::Matrix<double, Dim, Dim>::Zero();
    Box<Dim> around;
    around.lower.fill(-1);
    around.upper.fill(2);
    for_each<Dim>(around, [&](const Index<Dim>& step) {
      Point<Dim> way;
      for (int d = 0; d < Dim; ++d) way[d] = static_cast<double>(step[d]);
      if (way.isZero(0)) return;
      way.normalize();
      moments += std::max(0.0, shape_.distance(place + cell_ * way)) * way * way.transpose();
    });
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Dim, Dim>> axes(moments);
    return axes.eigenvectors().col(Dim - 1);
  }

  // How far a sheet goes on from a place in it.
  double extent(const Point<Dim>& place, const Point<Dim>& tangent, double most, double along) const {
    const double aside = 0.1 * along;  // by which a sheet may bend
    double low = 0, high = most + aside;
    const auto beyond = [&](double way) { return shape_.distance(place + way * tangent) > aside; };
    for (int n = 1; n <= 8; ++n)
      if (beyond(n * high / 8)) {
        low = (n - 1) * high / 8;
        high = n * high / 8;
        for (int halving = 0; halving < 8; ++halving) {
          const double middle = 0.5 * (low + high);
          (beyond(middle) ? high : low) = middle;
        }
        return std::max(0.0, low - aside);
      }
    return most;
  }

  static Points<Dim> tangents(const Point<Dim>& normal) {
    if constexpr (Dim == 2) return {turned_left<2>(normal)};
    constexpr int directions = 8;  // in half a turn
    Points<Dim> result;
    if constexpr (Dim == 3) {
      const Point<3> first = normal.unitOrthogonal(), second = normal.cross(first);
      for (int n = 0; n < directions; ++n) {
        const double angle = std::numbers::pi * n / directions;
        result.push_back(std::cos(angle) * first + std::sin(angle) * second);
      }
    }
    return result;
  }

  // 1/2 sum_d sigma^2 h_d^2 d2Phi/dx_d2 [m]
  double bending(const Point<Dim>& foot) const {
    double sum = 0;
    for (int d = 0; d < Dim; ++d) {
      const Point<Dim> aside = layout_.cell[d] * Point<Dim>::Unit(d);
      sum += shape_.distance(foot + aside) + shape_.distance(foot - aside) - 2 * shape_.distance(foot);
    }
    return 0.5 * layout_.moments.variance() * sum;
  }

  const Shape<Dim>& shape_;
  const MarkerLayout<Dim>& layout_;
  double cell_;
};

}  // namespace

template <int Dim>
MarkerPatches<Dim> surface_markers(const Shape<Dim>& shape, const Bounds<Dim>& region,
                                   const MarkerLayout<Dim>& layout) {
  const SeedCells<Dim> seeds(region, layout.cell);
  const Sinker<Dim> sinker(shape, layout);
  std::vector<Candidate<Dim>> candidates;
  subdivide<Dim>(
      seeds, seeds.box(), reach * layout.cell.maxCoeff(),
      [&](const Point<Dim>& place) { return shape.distance(place); }, [](const Box<Dim>&, int) {},
      [&](const Index<Dim>& cell) {
        if (const auto candidate = sinker.sink(seeds.center(cell))) candidates.push_back(*candidate);
      });
  // in an order that does not depend on the region, for what is equally crowded
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.place.begin(), a.place.end(), b.place.begin(), b.place.end());
  });
  const Point<Dim> spacing = layout.spacing * layout.cell;
  const auto markers = relaxed<Dim>(spread_evenly<Dim>(candidates, markers_a_patch * spacing), candidates, spacing);
  return gathered<Dim>(markers, spread_evenly<Dim>(markers, spacing), spacing);
}

template MarkerPatches<2> surface_markers<2>(const Shape<2>&, const Bounds<2>&, const MarkerLayout<2>&);
template MarkerPatches<3> surface_markers<3>(const Shape<3>&, const Bounds<3>&, const MarkerLayout<3>&);

}  // namespace washfsi
