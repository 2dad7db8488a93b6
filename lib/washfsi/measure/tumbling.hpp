// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// Counts the turns of cloths in a machine with a vertical axis: how often the centre of a cloth goes round a point of
/// the plane (r, z), r the distance from the axis. Up outside and down at the axis is positive (thesis Fig. 5.5-6).
class TumbleCounter {
 public:
  /// `axis` is x and y of the axis [m]; `orbit_center` is r and z of the point that cloths go round [m].
  TumbleCounter(const Point<2>& axis, const Point<2>& orbit_center, std::size_t cloths);

  /// Counts from the centres of all cloths after a step; the first call sets the start.
  void observe(const std::vector<Point<3>>& centers);
  /// Turns of each cloth so far.
  std::vector<double> turns() const;

  /// Numbers that a restart needs, to read and to set: the present angle of each cloth, and the angle turned so far.
  std::span<double> angles() { return angles_; }
  std::span<double> turned() { return turned_; }

 private:
  Point<2> axis_, orbit_center_;
  std::vector<double> angles_;  ///< present angle of each cloth on its way round, -pi to pi; NaN before the first
  std::vector<double> turned_;  ///< angles gone through so far [rad]
};

}  // namespace washfsi
