// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/mirror.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// Tolerances in cells.
constexpr double in_plane = 0.06;    // less than the way from a plane to the first seeds beside it
constexpr double exact = 1e-6;       // difference of the distances on both sides
constexpr double same_reach = 0.02;  // difference of the extents on both sides

template <int Dim>
std::array<int, Dim> thinnest_first(const Extent<Dim>& extent) {
  std::array<int, Dim> axes{};
  std::iota(axes.rbegin(), axes.rend(), 0);
  const Point<Dim> size = extent.bounds.upper - extent.bounds.lower;
  std::ranges::stable_sort(axes, {}, [&](int axis) { return size[axis]; });
  return axes;
}

}  // namespace

template <int Dim>
Mirror<Dim>::Mirror(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout,
                    const std::vector<Candidate<Dim>>& candidates)
    : near_(in_plane * layout.cell.minCoeff()) {
  const bool is_solid =
      std::ranges::all_of(candidates, [](const auto& candidate) { return candidate.place != candidate.foot; });
  if (is_solid) return;
  const Extent<Dim> extent = shape.extent();
  for (const int axis : thinnest_first(extent)) {
    axis_ = axis;
    middle_ = extent.is_finite(axis) ? 0.5 * (extent.bounds.lower[axis] + extent.bounds.upper[axis]) : 0;
    is_there_ = layout.period[axis] == 0 && is_plane(shape, layout, candidates);
    if (is_there_) return;
  }
}

template <int Dim>
bool Mirror<Dim>::is_plane(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout,
                           const std::vector<Candidate<Dim>>& candidates) const {
  double lowest = 0, highest = 0;
  for (const auto& candidate : candidates) {
    lowest = std::min(lowest, above(candidate.foot));
    highest = std::max(highest, above(candidate.foot));
  }
  const double cell = layout.cell.minCoeff();
  if (std::abs(lowest + highest) > same_reach * cell) return false;
  const auto rank = static_cast<std::size_t>(rank_of(layout.comm)),
             ranks = static_cast<std::size_t>(ranks_of(layout.comm));
  bool differs = false;
  for (std::size_t n = rank; n < candidates.size() && !differs; n += ranks)
    for (const Point<Dim>& place : {candidates[n].place, candidates[n].foot})
      differs = differs || std::abs(shape.distance(place) - shape.distance(image(place))) > exact * cell;
  return !any_rank(layout.comm, differs);
}

template <int Dim>
std::vector<Candidate<Dim>> Mirror<Dim>::half(const std::vector<Candidate<Dim>>& candidates) const {
  if (!is_there_) return candidates;
  std::vector<Candidate<Dim>> result;
  for (Candidate<Dim> candidate : candidates) {
    if (std::min(above(candidate.place), above(candidate.foot)) <= -near_) continue;
    for (Point<Dim>* place : {&candidate.place, &candidate.foot})
      if (above(*place) < near_) (*place)[axis_] = middle_;
    result.push_back(candidate);
  }
  return result;
}

template <int Dim>
MarkerPatches<Dim> Mirror<Dim>::whole(const MarkerPatches<Dim>& half) const {
  if (!is_there_) return half;
  MarkerPatches<Dim> result;
  for (std::size_t p = 0; p < half.size(); ++p) {
    const std::size_t begin = half.starts[p], end = half.starts[p + 1];
    bool crosses = false;
    for (std::size_t m = begin; m < end; ++m) {
      crosses = crosses || above(half.markers[m]) == 0;
      result.markers.push_back(half.markers[m]);
      result.feet.push_back(half.feet[m]);
    }
    if (!crosses) result.starts.push_back(result.markers.size());
    for (std::size_t m = begin; m < end; ++m) {
      if (above(half.markers[m]) == 0) continue;
      result.markers.push_back(image(half.markers[m]));
      result.feet.push_back(image(half.feet[m]));
    }
    result.starts.push_back(result.markers.size());
  }
  return result;
}

template class Mirror<2>;
template class Mirror<3>;

}  // namespace washfsi
