// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

ClothCrossings::ClothCrossings(const Cloths<3>& cloths) : cloths_(cloths), known_(cloths, {}), facets_(cloths, known_) {
  double shortest = 1e300;
  for (const ClothGroup<3>& group : cloths.groups()) shortest = std::min({shortest, group.sheet.ds, group.sheet.dr});
  reach_ = 0.5 * shortest;
}

// Whether a marker changed sides of a triangle's plane in the step and was over the triangle when it did so; both move
// straight.
bool ClothCrossings::crosses(std::size_t marker, const Corners& corners, const Ways& ways) const {
  const Triangle first = triangle_of(corners, ways.before), last = triangle_of(corners, ways.now);
  const double side_before = (ways.before[marker] - first[0]).dot(area_normal(first).normalized());
  const double side_now = (ways.now[marker] - last[0]).dot(area_normal(last).normalized());
  if (side_before * side_now >= 0) return false;
  const double part = side_before / (side_before - side_now);
  const auto between = [&](const Point<3>& from, const Point<3>& to) -> Point<3> { return from + part * (to - from); };
  const Triangle then{between(first[0], last[0]), between(first[1], last[1]), between(first[2], last[2])};
  const Point<3> place = between(ways.before[marker], ways.now[marker]);
  const double from_plane = std::abs((place - then[0]).dot(area_normal(then).normalized()));
  return (nearest_on(then, place).place - place).norm() <= 1e-6 * reach_ + from_plane;
}

Triangle ClothCrossings::triangle_of(const Corners& corners, const Points<3>& places) {
  return {places[corners[0]], places[corners[1]], places[corners[2]]};
}

Bounds<3> ClothCrossings::Ways::bounds(std::size_t marker) const {
  return hull<3>({{now[marker], now[marker]}, {before[marker], before[marker]}});
}

// The places of the markers that may have met this rank's, or be within their reach.
ClothCrossings::Ways ClothCrossings::ways_to(const Points<3>& positions) {
  const Points<3>& before = is_first_ ? positions : before_;
  std::vector<double> lengths;
  for (std::size_t m = 0; m < positions.size(); ++m) lengths.push_back((positions[m] - before[m]).norm());
  if (known_.choose(positions, lengths, reach_)) facets_ = Facets<3>(cloths_, known_);
  return {known_.values(before), known_.values(positions)};
}

void ClothCrossings::observe(const Points<3>& positions) {
  const Ways ways = ways_to(positions);
  const Point<3> margin = Point<3>::Constant(reach_);
  std::vector<Bounds<3>> swept, asked;
  for (const Corners& corners : facets_.faces)
    swept.push_back(hull<3>({ways.bounds(corners[0]), ways.bounds(corners[1]), ways.bounds(corners[2])}));
  for (std::size_t m = known_.begin(); m < known_.begin() + positions.size(); ++m)
    asked.push_back({ways.bounds(m).lower - margin, ways.bounds(m).upper + margin});
  const NearSearch<3> search(std::move(swept), 4 * margin, hull(asked));
  double least = reach_, crossed = 0;
  for (std::size_t n = 0; n < asked.size(); ++n)
    for (const std::size_t t : search.near(asked[n])) {
      const std::size_t m = known_.begin() + n;
      const Corners& corners = facets_.faces[t];
      if (known_.piece_of(corners[0]) == known_.piece_of(m)) continue;
      least = std::min(least, (nearest_on(triangle_of(corners, ways.now), ways.now[m]).place - ways.now[m]).norm());
      if (!is_first_ && crosses(m, corners, ways)) crossed += 1;
    }
  least_distance_ = -largest(cloths_.comm(), -least);
  crossings_ += ordered_sum(cloths_.comm(), crossed);
  before_ = positions;
  is_first_ = false;
}

}  // namespace washfsi
