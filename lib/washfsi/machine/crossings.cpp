// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/machine/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

struct TriangleAt {
  Point<3> a, b, c;
  Point<3> area_normal() const { return (b - a).cross(c - a); }
};

// Distance of a place from a triangle: from its plane, or from its nearest side.
double distance_to(const TriangleAt& triangle, const Point<3>& place) {
  const auto to_side = [&](const Point<3>& from, const Point<3>& to) {
    return way_from_segment<3>(from, to - from, place).norm();
  };
  const Point<3> normal = triangle.area_normal();
  const auto is_left_of = [&](const Point<3>& from, const Point<3>& to) {
    return (to - from).cross(place - from).dot(normal) >= 0;
  };
  if (is_left_of(triangle.a, triangle.b) && is_left_of(triangle.b, triangle.c) && is_left_of(triangle.c, triangle.a))
    return std::abs((place - triangle.a).dot(normal)) / normal.norm();
  return std::min({to_side(triangle.a, triangle.b), to_side(triangle.b, triangle.c), to_side(triangle.c, triangle.a)});
}

}  // namespace

ClothCrossings::ClothCrossings(const Cloths<3>& cloths) : cloths_(cloths) {
  double shortest = 1e300;
  for (std::size_t p = 0; p < cloths.pieces().size(); ++p) {
    const Piece& piece = cloths.pieces()[p];
    const Sheet& sheet = cloths.groups()[piece.group].sheet;
    for (const auto& quad : cloths.quads(piece)) {
      const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(quad[k]); };
      triangles_.push_back({corner(0), corner(3), corner(2)});
      triangles_.push_back({corner(0), corner(2), corner(1)});
      piece_of_triangle_.insert(piece_of_triangle_.end(), 2, p);
    }
    shortest = std::min({shortest, sheet.ds, sheet.dr});
  }
  reach_ = 0.5 * shortest;
}

ClothCrossings::Bin ClothCrossings::bin_of(const Point<3>& place) const {
  Bin bin{};
  for (std::size_t d = 0; d < 3; ++d) bin[d] = static_cast<long>(std::floor(place[static_cast<int>(d)] / (4 * reach_)));
  return bin;
}

void ClothCrossings::sort_into_bins(const Points<3>& places) {
  bins_.clear();
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t];
    const Point<3> margin = Point<3>::Constant(reach_);
    const Bin lower = bin_of(places[a].cwiseMin(places[b]).cwiseMin(places[c]) - margin);
    const Bin upper = bin_of(places[a].cwiseMax(places[b]).cwiseMax(places[c]) + margin);
    for (long i = lower[0]; i <= upper[0]; ++i)
      for (long j = lower[1]; j <= upper[1]; ++j)
        for (long k = lower[2]; k <= upper[2]; ++k) bins_.push_back({{i, j, k}, t});
  }
  std::sort(bins_.begin(), bins_.end());
}

// Whether a marker changed sides of a triangle's plane in the step and was over the triangle when it did so; both move
// straight.
bool ClothCrossings::crosses(std::size_t marker, const Triangle& triangle, const Points<3>& now) const {
  const auto triangle_in = [&](const Points<3>& places) {
    return TriangleAt{places[triangle[0]], places[triangle[1]], places[triangle[2]]};
  };
  const TriangleAt first = triangle_in(before_), last = triangle_in(now);
  const double side_before = (before_[marker] - first.a).dot(first.area_normal().normalized());
  const double side_now = (now[marker] - last.a).dot(last.area_normal().normalized());
  if (side_before * side_now >= 0) return false;
  const double part = side_before / (side_before - side_now);
  const auto between = [&](const Point<3>& from, const Point<3>& to) -> Point<3> { return from + part * (to - from); };
  const TriangleAt then{between(first.a, last.a), between(first.b, last.b), between(first.c, last.c)};
  const Point<3> place = between(before_[marker], now[marker]);
  return distance_to(then, place) <= 1e-6 * reach_ + std::abs((place - then.a).dot(then.area_normal().normalized()));
}

void ClothCrossings::observe(const Points<3>& positions) {
  const Points<3> now = cloths_.of_all_ranks(positions);
  sort_into_bins(now);
  double least = reach_, crossed = 0;
  for (std::size_t m = 0; m < positions.size(); ++m) {
    const std::size_t marker = static_cast<std::size_t>(cloths_.begin()) + m, piece = cloths_.piece_of_marker()[m];
    const Bin bin = bin_of(now[marker]);
    const auto first = std::lower_bound(bins_.begin(), bins_.end(), std::pair{bin, std::size_t{0}});
    for (auto entry = first; entry != bins_.end() && entry->first == bin; ++entry) {
      if (piece_of_triangle_[entry->second] == piece) continue;
      const Triangle& triangle = triangles_[entry->second];
      least = std::min(least, distance_to({now[triangle[0]], now[triangle[1]], now[triangle[2]]}, now[marker]));
      if (!before_.empty() && crosses(marker, triangle, now)) crossed += 1;
    }
  }
  least_distance_ = -largest(cloths_.comm(), -least);
  crossings_ += ordered_sum(cloths_.comm(), crossed);
  before_ = now;
}

}  // namespace washfsi
