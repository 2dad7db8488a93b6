// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/surface_markers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "washfsi/grid/subdivide.hpp"
#include "washfsi/marker_layout/marker_retraction.hpp"
#include "washfsi/marker_layout/mirror.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi {

namespace {

template <int Dim>
constexpr double seeds_a_cell = Dim == 2 ? 8 : 3;
constexpr double marker_spacing = 0.54;    // least distance of markers on faces beside thin parts [cells]
constexpr double spacing_on_solids = 0.7;  // in space fewer markers suffice round a solid
constexpr double wider_on_solids = 1.3;    // wider patches suffice there, in the plane too

// For thin parts. In space these have few patches, which must be even: they come from finer seeds and places, of which
// a selection stands for all.
template <int Dim>
constexpr double sheet_seeds_a_cell = Dim == 2 ? 8 : 6;
template <int Dim>
constexpr double sheet_spacing = Dim == 2 ? marker_spacing : 0.3;  // least distance of places [cells]
constexpr double sheet_width = 1.2;                                // width of patches over the layout's
constexpr double least_sheet_width = 0.75;                         // least width where sheets meet [cells]
constexpr std::size_t sheet_markers = 4;                           // most markers in a patch

/// Cells that each seed one place of the surface, counted from the shape's origin, so that markers do not depend on
/// where the shape is.
template <int Dim>
class SeedCells {
 public:
  SeedCells(const Bounds<Dim>& region, const Point<Dim>& spacing) : spacing_(spacing) {
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

// The candidates that retracted(seed) finds, in an order independent of the region, which decides between equally
// crowded ones. Ranks take seeds in turns, since expensive ones are near each other.
template <int Dim, class Retracted>
std::vector<Candidate<Dim>> candidates_of(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout,
                                          const SeedCells<Dim>& seeds, const Retracted& retracted) {
  std::vector<Index<Dim>> near;
  subdivide<Dim>(
      seeds, seeds.box(), MarkerRetraction<Dim>::reach * layout.cell.maxCoeff(),
      [&](const Point<Dim>& place) { return shape.distance(place); }, [](const Box<Dim>&, int) {},
      [&](const Index<Dim>& cell) { near.push_back(cell); });
  const auto rank = static_cast<std::size_t>(rank_of(layout.comm)),
             ranks = static_cast<std::size_t>(ranks_of(layout.comm));
  std::vector<Candidate<Dim>> mine;
  for (std::size_t n = rank; n < near.size(); n += ranks)
    if (const auto candidate = retracted(seeds.center(near[n]))) mine.push_back(*candidate);
  std::vector<Candidate<Dim>> candidates = of_all_ranks(layout.comm, mine);
  std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.place.begin(), a.place.end(), b.place.begin(), b.place.end());
  });
  return candidates;
}

// Keeps one of the candidates in the middle of a part that share a cell, the nearest to the cell's seed; rounds places,
// so that equally crowded ones are exactly so along all axes. Neither seeds nor planes of symmetry lie on the sides of
// the cells.
template <int Dim>
std::vector<Candidate<Dim>> distinct(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing) {
  const Point<Dim> fine = 0.01 * spacing;
  std::map<std::pair<Index<Dim>, int>, std::pair<double, Point<Dim>>> found;
  for (const auto& candidate : candidates) {
    Index<Dim> cell;
    Point<Dim> seed;
    for (int d = 0; d < Dim; ++d) {
      cell[d] = std::lround(candidate.place[d] / spacing[d] + 0.25);
      seed[d] = (static_cast<double>(cell[d]) - 0.5) * spacing[d];
    }
    const Point<Dim> place = candidate.place.cwiseQuotient(fine).array().round().matrix().cwiseProduct(fine);
    const double apart = (place - seed).cwiseQuotient(spacing).norm();
    const auto [known, is_new] = found.try_emplace({cell, candidate.sharpness}, apart, place);
    if (!is_new && apart < known->second.first) known->second = {apart, place};
  }
  std::vector<Candidate<Dim>> result;
  for (const auto& [key, nearest] : found) result.push_back({nearest.second, nearest.second, key.second});
  return result;
}

// The number of patches of a width for so many markers a spacing apart.
template <int Dim>
std::size_t patch_count(std::size_t markers, double spacing, double width) {
  const double in_one = std::pow(std::max(1.0, width / spacing), Dim - 1);
  const auto count = static_cast<std::size_t>(std::ceil(static_cast<double>(markers) / in_one - 0.5));
  return std::min(markers, std::max<std::size_t>(count, 1));
}

// Whether a candidate lies behind a face, and not in the middle of a thin part or in a corner.
template <int Dim>
bool is_behind_face(const Candidate<Dim>& candidate) {
  return candidate.place != candidate.foot;
}

template <int Dim>
std::vector<Candidate<Dim>> behind_faces(const std::vector<Candidate<Dim>>& candidates) {
  std::vector<Candidate<Dim>> result;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(result), is_behind_face<Dim>);
  return result;
}

// Whether a part that has all these candidates or places is thin nowhere.
template <int Dim>
bool is_solid(const std::vector<Candidate<Dim>>& of_part) {
  return std::all_of(of_part.begin(), of_part.end(), is_behind_face<Dim>);
}

// Spacing of the markers of a part with all these candidates or places [cells].
template <int Dim>
double spacing_in(const std::vector<Candidate<Dim>>& of_part) {
  return Dim == 3 && is_solid<Dim>(of_part) ? spacing_on_solids : marker_spacing;
}

// The markers of a part. On solids a sample of the candidates serves as well as all.
template <int Dim>
std::vector<Candidate<Dim>> markers_among(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& cell) {
  const double spacing = spacing_in<Dim>(candidates);
  if (spacing == marker_spacing) return spread_evenly<Dim>(candidates, spacing * cell);
  return spread_evenly<Dim>(thinned<Dim>(candidates, 0.15 * spacing * cell), spacing * cell);
}

template <int Dim>
MarkerPatches<Dim> patches_of_sheets(const Shape<Dim>& shape, const Bounds<Dim>& region,
                                     const MarkerLayout<Dim>& layout) {
  const SeedCells<Dim> seeds(region, layout.cell / sheet_seeds_a_cell<Dim>);
  const MarkerRetraction<Dim> retraction(shape, layout);
  const auto candidates = candidates_of<Dim>(
      shape, layout, seeds, [&](const Point<Dim>& seed) { return retraction.retracted_without_face(seed); });
  const Mirror<Dim> mirror(shape, layout, candidates);
  const auto places =
      spread_evenly<Dim>(mirror.half(distinct<Dim>(candidates, seeds.spacing())), sheet_spacing<Dim> * layout.cell);
  const double width = sheet_width * layout.spacing;
  const std::size_t apart = thinned<Dim>(places, least_sheet_width * layout.cell).size();
  const std::size_t count = std::min(apart, patch_count<Dim>(places.size(), sheet_mean_spacing<Dim>, width));
  return mirror.whole(gathered<Dim>(places, count, width * layout.cell, sheet_markers));
}

/// The candidates of a part on one side of its mirror: on faces; in corners and thin parts.
template <int Dim>
struct Places {
  std::vector<Candidate<Dim>> half;
  Mirror<Dim> mirror;
};

// The work within one part cannot be divided, so ranks take parts in turns.
template <int Dim>
std::vector<Places<Dim>> places_of(const std::vector<Surface<Dim>>& parts) {
  std::vector<Places<Dim>> places;
  for (const auto& [shape, region, layout] : parts) {
    const SeedCells<Dim> seeds(region, layout.cell / seeds_a_cell<Dim>);
    const MarkerRetraction<Dim> retraction(*shape, layout);
    const auto all =
        candidates_of<Dim>(*shape, layout, seeds, [&](const Point<Dim>& seed) { return retraction.retracted(seed); });
    const Mirror<Dim> mirror(*shape, layout, all);
    places.push_back({mirror.half(all), mirror});
  }
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const MarkerLayout<Dim>& layout = parts[n].layout;
    const bool is_mine = static_cast<int>(n) % ranks_of(layout.comm) == rank_of(layout.comm);
    places[n].half = is_mine ? markers_among<Dim>(places[n].half, layout.cell) : std::vector<Candidate<Dim>>();
  }
  for (std::size_t n = 0; n < parts.size(); ++n) places[n].half = of_all_ranks(parts[n].layout.comm, places[n].half);
  return places;
}

template <int Dim>
MarkerPatches<Dim> patches_of(const Places<Dim>& places, const Surface<Dim>& part) {
  const auto& [shape, region, layout] = part;
  const auto& [markers, mirror] = places;
  const auto on_faces = behind_faces<Dim>(markers);
  const bool solid = is_solid<Dim>(markers);
  const double width = layout.spacing * (solid ? wider_on_solids : 1);
  const auto most = on_faces.size();
  MarkerPatches<Dim> patches = mirror.whole(
      gathered<Dim>(on_faces, patch_count<Dim>(most, spacing_in<Dim>(markers), width), width * layout.cell, most));
  if (!solid) patches.append(patches_of_sheets<Dim>(*shape, region, layout));
  return patches;
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

/// Assembles the markers of a body's parts. Each part is laid out in its own frame, so that equal parts have equal
/// markers however the body is turned.
template <int Dim>
class Assembly {
 public:
  // Adds the parts that are not copies of others to a list.
  Assembly(const Surface<Dim>& surface, std::vector<Surface<Dim>>& distinct_parts)
      : layout_(surface.layout), region_(surface.region) {
    surface.shape->add_parts({}, parts_);
    std::map<const Shape<Dim>*, std::size_t> numbers;
    for (const auto& [part, pose] : parts_) {
      const Bounds<Dim> seen = seen_from(pose, surface.region);
      const auto [known, is_new] = numbers.emplace(part, distinct_parts.size());
      number_of_.push_back(known->second);
      if (is_new)
        distinct_parts.push_back({part, seen, layout_});
      else
        distinct_parts[known->second].region.include(seen);
    }
  }

  // Assembles the body's markers from those of each part in the list.
  MarkerPatches<Dim> of(const std::vector<MarkerPatches<Dim>>& laid) {
    for (std::size_t part = 0; part < parts_.size(); ++part) add(part, laid[number_of_[part]]);
    return distinct_patches();
  }

 private:
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

  // Omits markers whose feet lie within another part or in the next period, and those too near to a marker of an
  // earlier part or period.
  MarkerPatches<Dim> distinct_patches() const {
    MarkerPatches<Dim> result;
    const std::vector<Bounds<Dim>> bounds = bounds_of(places_);
    const NearSearch<Dim> search(bounds, layout_.cell, hull(bounds));
    std::vector<char> stays(places_.size(), 0);
    std::size_t m = 0;
    for (const std::size_t end : ends_) {
      for (; m < end; ++m) {
        stays[m] = is_in_period(m) && !is_hidden(m) && !is_crowded(m, stays, search);
        if (!stays[m]) continue;
        result.markers.push_back(places_[m]);
        result.feet.push_back(feet_[m]);
      }
      if (result.markers.size() > result.starts.back()) result.starts.push_back(result.markers.size());
    }
    return result;
  }

  bool is_hidden(std::size_t m) const {
    const double depth = 0.2 * layout_.cell.minCoeff();  // so that thin sheets that cross both stay
    for (std::size_t part = 0; part < parts_.size(); ++part)
      if (part != part_of_[m] && parts_[part].shape->distance(parts_[part].pose.in_body_frame(feet_[m])) < -depth)
        return true;
    return false;
  }
  bool is_in_period(std::size_t m) const {
    for (int d = 0; d < Dim; ++d)
      if (layout_.period[d] > 0 && (places_[m][d] < region_.lower[d] || places_[m][d] >= region_.upper[d]))
        return false;
    return true;
  }
  bool is_crowded(std::size_t m, const std::vector<char>& stays, const NearSearch<Dim>& search) const {
    const Point<Dim> limit = 0.7 * marker_spacing * layout_.cell;
    const auto meets = [&](const Point<Dim>& place, auto&& counts) {
      return std::ranges::any_of(search.near(Bounds<Dim>::round(place, limit)), [&](std::size_t other) {
        return stays[other] && counts(other) && (places_[other] - place).cwiseQuotient(limit).norm() < 1;
      });
    };
    for (int d = 0; d < Dim; ++d)
      for (const int way : {-1, 1})
        if (layout_.period[d] > 0 &&
            meets(places_[m] + way * layout_.period[d] * Point<Dim>::Unit(d), [](std::size_t) { return true; }))
          return true;
    return meets(places_[m], [&](std::size_t other) { return part_of_[other] != part_of_[m]; });
  }

  MarkerLayout<Dim> layout_;
  Bounds<Dim> region_;
  std::vector<typename Shape<Dim>::Part> parts_;
  std::vector<std::size_t> number_of_;  ///< number of each part in the list
  Points<Dim> places_, feet_;
  std::vector<std::size_t> part_of_, ends_;  ///< part of each marker; end of each patch
};

}  // namespace

template <int Dim>
std::vector<MarkerPatches<Dim>> surface_markers(const std::vector<Surface<Dim>>& surfaces) {
  std::vector<Surface<Dim>> parts;
  std::vector<Assembly<Dim>> assemblies;
  for (const auto& surface : surfaces) assemblies.emplace_back(surface, parts);
  const auto places = places_of<Dim>(parts);
  std::vector<MarkerPatches<Dim>> laid, result;
  for (std::size_t n = 0; n < parts.size(); ++n) laid.push_back(patches_of<Dim>(places[n], parts[n]));
  for (auto& assembly : assemblies) result.push_back(assembly.of(laid));
  return result;
}

template std::vector<MarkerPatches<2>> surface_markers<2>(const std::vector<Surface<2>>&);
template std::vector<MarkerPatches<3>> surface_markers<3>(const std::vector<Surface<3>>&);

}  // namespace washfsi
