// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/machine/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

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

// Whether a marker changed sides of a triangle's plane in the step and was over the triangle when it did so; both move
// straight.
bool ClothCrossings::crosses(std::size_t marker, const Corners& corners, const Points<3>& now) const {
  const Triangle first = triangle_of(corners, before_), last = triangle_of(corners, now);
  const double side_before = (before_[marker] - first[0]).dot(area_normal(first).normalized());
  const double side_now = (now[marker] - last[0]).dot(area_normal(last).normalized());
  if (side_before * side_now >= 0) return false;
  const double part = side_before / (side_before - side_now);
  const auto between = [&](const Point<3>& from, const Point<3>& to) -> Point<3> { return from + part * (to - from); };
  const Triangle then{between(first[0], last[0]), between(first[1], last[1]), between(first[2], last[2])};
  const Point<3> place = between(before_[marker], now[marker]);
  const double from_plane = std::abs((place - then[0]).dot(area_normal(then).normalized()));
  return (nearest_on(then, place).place - place).norm() <= 1e-6 * reach_ + from_plane;
}

Triangle ClothCrossings::triangle_of(const Corners& corners, const Points<3>& places) {
  return {places[corners[0]], places[corners[1]], places[corners[2]]};
}

// Where a marker was and is.
Bounds<3> ClothCrossings::way_of(std::size_t marker, const Points<3>& now) const {
  Bounds<3> way{now[marker], now[marker]};
  if (!before_.empty()) way.include({before_[marker], before_[marker]});
  return way;
}

void ClothCrossings::observe(const Points<3>& positions) {
  const Points<3> now = cloths_.of_all_ranks(positions);
  const auto begin = static_cast<std::size_t>(cloths_.begin());
  const Point<3> margin = Point<3>::Constant(reach_);
  std::vector<Bounds<3>> swept, asked;
  for (const Corners& corners : triangles_)
    swept.push_back(hull<3>({way_of(corners[0], now), way_of(corners[1], now), way_of(corners[2], now)}));
  for (std::size_t m = 0; m < positions.size(); ++m) {
    const Bounds<3> way = way_of(begin + m, now);
    asked.push_back({way.lower - margin, way.upper + margin});
  }
  const NearSearch<3> search(std::move(swept), 4 * margin, hull(asked));
  double least = reach_, crossed = 0;
  for (std::size_t m = 0; m < positions.size(); ++m)
    for (const std::size_t t : search.near(asked[m])) {
      if (piece_of_triangle_[t] == cloths_.piece_of_marker()[m]) continue;
      const Point<3>& place = now[begin + m];
      least = std::min(least, (nearest_on(triangle_of(triangles_[t], now), place).place - place).norm());
      if (!before_.empty() && crosses(begin + m, triangles_[t], now)) crossed += 1;
    }
  least_distance_ = -largest(cloths_.comm(), -least);
  crossings_ += ordered_sum(cloths_.comm(), crossed);
  before_ = now;
}

}  // namespace washfsi
