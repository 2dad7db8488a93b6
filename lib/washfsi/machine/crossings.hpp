// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Watches how close sheets come to each other, and counts markers that go through others. Water between them keeps
/// cloths apart as long as the grid resolves it; what it does not, these numbers tell.
class ClothCrossings {
 public:
  explicit ClothCrossings(const Cloths<3>& cloths);

  /// Takes the places of this rank's markers after a step; the first ones only begin. Collective.
  void observe(const Points<3>& positions);

  /// Markers that went through a triangle of another cloth, so far.
  double crossings() const { return crossings_; }
  void set_crossings(double crossings) { crossings_ = crossings; }
  /// Least distance of a marker from another cloth now [m]; at most `reach()`, beyond which it is not known.
  double least_distance() const { return least_distance_; }
  double reach() const { return reach_; }

 private:
  using Triangle = std::array<std::size_t, 3>;
  using Bin = std::array<long, 3>;
  void sort_into_bins(const Points<3>& places);
  Bin bin_of(const Point<3>& place) const;
  bool crosses(std::size_t marker, const Triangle& triangle, const Points<3>& now) const;

  const Cloths<3>& cloths_;
  std::vector<Triangle> triangles_;
  std::vector<std::size_t> piece_of_triangle_;
  double reach_ = 0;
  std::vector<std::pair<Bin, std::size_t>> bins_;  ///< triangles by the bins that they come near to, sorted
  Points<3> before_;                               ///< of all markers
  double crossings_ = 0, least_distance_ = 0;
};

}  // namespace washfsi
