// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "washfsi/cloth/facets.hpp"
#include "washfsi/geometry/near_search.hpp"
#include "washfsi/geometry/nearest.hpp"

namespace washfsi {

/// Measures how close sheets come to each other, and counts markers that go through others. Water between them keeps
/// cloths apart as long as the grid resolves it; these numbers show where it does not.
class ClothCrossings {
 public:
  /// Collective.
  explicit ClothCrossings(const Cloths<3>& cloths);

  /// Compares the places of this rank's markers after a step with the previous ones, if there are any. Collective.
  void observe(const Points<3>& positions);

  /// The number of times that a marker went through a triangle of another cloth, so far.
  double crossings() const { return crossings_; }
  /// This number, for a restart to read and to set.
  std::span<double> state() { return {&crossings_, 1}; }
  /// Least distance of a marker from another cloth now [m]; at most `reach()`, beyond which it is not known.
  double least_distance() const { return least_distance_; }
  double reach() const { return reach_; }

 private:
  using Corners = Facets<3>::Face;
  /// Previous and present places of the markers that this rank knows.
  struct Ways {
    Points<3> before, now;

    Bounds<3> bounds(std::size_t marker) const;
  };
  Ways ways_to(const Points<3>& positions);
  bool crosses(std::size_t marker, const Corners& corners, const Ways& ways) const;
  static Triangle triangle_of(const Corners& corners, const Points<3>& places);

  const Cloths<3>& cloths_;
  NearMarkers<3> known_;
  Facets<3> facets_;
  double reach_ = 0;
  bool is_first_ = true;
  Points<3> before_;  ///< previous places of this rank's markers
  double crossings_ = 0, least_distance_ = 0;
};

}  // namespace washfsi
