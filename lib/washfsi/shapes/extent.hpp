// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "washfsi/geometry/near_search.hpp"
#include "washfsi/shapes/pose.hpp"

namespace washfsi {

/// A box that holds all of a solid; or, of one that goes on without end, all that it leaves open, as of a drum. Both
/// may be larger than they must. Without bounds along an axis they are infinite there.
template <int Dim>
struct Extent {
  Bounds<Dim> bounds;       ///< [m]
  bool of_opening = false;  ///< they hold what is not in the solid

  static Extent infinite();
  /// Whether there are bounds along an axis.
  bool is_finite(int axis) const;

  /// The same of the complement; of a solid that is grown by a radius; of one that is in this place.
  Extent inverted() const { return {bounds, !of_opening}; }
  Extent grown(double radius) const;
  Extent in_space(const Pose<Dim>& pose) const;

  /// Of what is in any of some solids, at least one; in all of them.
  static Extent of_union(const std::vector<Extent>& parts);
  static Extent of_intersection(std::vector<Extent> parts);
};

extern template struct Extent<2>;
extern template struct Extent<3>;

}  // namespace washfsi
