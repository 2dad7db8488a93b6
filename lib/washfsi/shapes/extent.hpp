// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "washfsi/geometry/near_search.hpp"
#include "washfsi/shapes/pose.hpp"

namespace washfsi {

/// A box that contains all of a solid or, for an endless one such as a drum, its whole opening. Both may be larger than
/// necessary, and are infinite along an axis without bounds.
template <int Dim>
struct Extent {
  Bounds<Dim> bounds;       ///< [m]
  bool of_opening = false;  ///< whether they contain what is not in the solid

  static Extent infinite();
  /// Whether there are bounds along an axis.
  bool is_finite(int axis) const;

  /// The extents of the complement; of the solid grown by a radius; of the solid in this place.
  Extent inverted() const { return {bounds, !of_opening}; }
  Extent grown(double radius) const;
  Extent in_space(const Pose<Dim>& pose) const;

  /// The extents of the union of at least one solid; of their intersection.
  static Extent of_union(const std::vector<Extent>& parts);
  static Extent of_intersection(std::vector<Extent> parts);
};

extern template struct Extent<2>;
extern template struct Extent<3>;

}  // namespace washfsi
