// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/surface_markers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "washfsi/body/subdivide.hpp"
#include "washfsi/forcing/sinker.hpp"

namespace washfsi {

namespace {

template <int Dim>
constexpr double seeds_a_cell = Dim == 2 ? 8 : 3;
constexpr double marker_spacing = 0.54;  // least distance of markers [cells]
constexpr double wider_on_solids = 1.3;  // what closes round a solid is held as well by wider patches

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

// Markers in the middle of a sheet are on no face of it.
template <int Dim>
bool has_sheets(const std::vector<Candidate<Dim>>& markers) {
  return std::any_of(markers.begin(), markers.end(), [](const auto& marker) { return marker.place == marker.foot; });
}

template <int Dim>
MarkerPatches<Dim> markers_of_part(const Shape<Dim>& shape, const Bounds<Dim>& region,
                                   const MarkerLayout<Dim>& layout) {
  const SeedCells<Dim> seeds(region, layout.cell);
  const Sinker<Dim> sinker(shape, layout);
  std::vector<Candidate<Dim>> candidates;
  subdivide<Dim>(
      seeds, seeds.box(), Sinker<Dim>::reach * layout.cell.maxCoeff(),
      [&](const Point<Dim>& place) { return shape.distance(place); }, [](const Box<Dim>&, int) {},
      [&](const Index<Dim>& cell) {
        if (const auto candidate = sinker.sink(seeds.center(cell))) candidates.push_back(*candidate);
      });
  // in an order that does not depend on the region, for what is equally crowded
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.place.begin(), a.place.end(), b.place.begin(), b.place.end());
  });
  const auto markers = spread_evenly<Dim>(candidates, marker_spacing * layout.cell);
  const double width = layout.spacing * (has_sheets<Dim>(markers) ? 1 : wider_on_solids);
  const double in_one = std::pow(std::max(1.0, width / marker_spacing), Dim - 1);
  const auto count = static_cast<std::size_t>(std::ceil(static_cast<double>(markers.size()) / in_one - 0.5));
  return gathered<Dim>(markers, std::min(markers.size(), std::max<std::size_t>(count, 1)), width * layout.cell);
}

// The box round a region as it is in the frame of a part.
template <int Dim>
Bounds<Dim> seen_from(const Pose<Dim>& pose, const Bounds<Dim>& region) {
  const Point<Dim> middle = 0.5 * (region.lower + region.upper), half = 0.5 * (region.upper - region.lower);
  Point<Dim> turned = half;
  turned[0] = std::abs(pose.cosine) * half[0] + std::abs(pose.sine) * half[1];
  turned[1] = std::abs(pose.sine) * half[0] + std::abs(pose.cosine) * half[1];
  return Bounds<Dim>::round(pose.in_body_frame(middle), turned);
}

/// Puts the markers of a body's parts together.
template <int Dim>
class Assembly {
 public:
  using Part = typename Shape<Dim>::Part;
  Assembly(const std::vector<Part>& parts, const MarkerLayout<Dim>& layout) : parts_(parts), layout_(layout) {}

  void add(std::size_t part, const MarkerPatches<Dim>& patches) {
    for (std::size_t p = 0; p < patches.size(); ++p) {
      for (std::size_t m = patches.starts[p]; m < patches.starts[p + 1]; ++m) {
        places_.push_back(parts_[part].pose.in_space(patches.markers[m]));
        feet_.push_back(parts_[part].pose.in_space(patches.feet[m]));
        part_of_.push_back(part);
      }
      ends_.push_back(places_.size());
    }
  }

  // Without those that hold what lies within another part, and those too near to one of a part before.
  MarkerPatches<Dim> patches() const {
    MarkerPatches<Dim> result;
    const std::vector<Bounds<Dim>> bounds = bounds_of(places_);
    const NearSearch<Dim> search(bounds, layout_.cell, hull(bounds));
    std::vector<char> stays(places_.size(), 0);
    std::size_t m = 0;
    for (const std::size_t end : ends_) {
      for (; m < end; ++m) {
        stays[m] = !is_hidden(m) && !is_crowded(m, stays, search);
        if (!stays[m]) continue;
        result.markers.push_back(places_[m]);
        result.feet.push_back(feet_[m]);
      }
      if (result.markers.size() > result.starts.back()) result.starts.push_back(result.markers.size());
    }
    return result;
  }

 private:
  bool is_hidden(std::size_t m) const {
    const double depth = 0.2 * layout_.cell.minCoeff();  // so that thin sheets that cross both stay
    for (std::size_t part = 0; part < parts_.size(); ++part)
      if (part != part_of_[m] && parts_[part].shape->distance(parts_[part].pose.in_body_frame(feet_[m])) < -depth)
        return true;
    return false;
  }
  bool is_crowded(std::size_t m, const std::vector<char>& stays, const NearSearch<Dim>& search) const {
    const Point<Dim> limit = 0.7 * marker_spacing * layout_.cell;
    for (const std::size_t other : search.near(Bounds<Dim>::round(places_[m], limit)))
      if (stays[other] && part_of_[other] != part_of_[m] &&
          (places_[other] - places_[m]).cwiseQuotient(limit).norm() < 1)
        return true;
    return false;
  }

  const std::vector<Part>& parts_;
  const MarkerLayout<Dim>& layout_;
  Points<Dim> places_, feet_;
  std::vector<std::size_t> part_of_, ends_;  ///< of each marker; of each patch
};

}  // namespace

// Each part in its own frame, so that equal parts have equal markers however a body is turned.
template <int Dim>
MarkerPatches<Dim> surface_markers(const Shape<Dim>& shape, const Bounds<Dim>& region,
                                   const MarkerLayout<Dim>& layout) {
  std::vector<typename Shape<Dim>::Part> parts;
  shape.add_parts({}, parts);
  std::map<const Shape<Dim>*, Bounds<Dim>> regions;
  for (const auto& [part, pose] : parts) {
    const Bounds<Dim> seen = seen_from(pose, region);
    const auto [place, is_new] = regions.emplace(part, seen);
    if (!is_new) place->second.include(seen);
  }
  std::map<const Shape<Dim>*, MarkerPatches<Dim>> laid;
  for (const auto& [part, seen] : regions) laid.emplace(part, markers_of_part(*part, seen, layout));
  Assembly<Dim> assembly(parts, layout);
  for (std::size_t n = 0; n < parts.size(); ++n) assembly.add(n, laid.at(parts[n].shape));
  return assembly.patches();
}

template MarkerPatches<2> surface_markers<2>(const Shape<2>&, const Bounds<2>&, const MarkerLayout<2>&);
template MarkerPatches<3> surface_markers<3>(const Shape<3>&, const Bounds<3>&, const MarkerLayout<3>&);

}  // namespace washfsi
