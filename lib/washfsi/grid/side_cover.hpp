// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// The velocity along a no-slip side of the box where bodies stand on it, at two moments: the ends of the step under
/// way. Kept for the faces beside this rank's cells and ghosts.
template <int Dim>
class SideCover {
 public:
  /// The velocity [m/s] at a place of the side, whose own is given.
  using Velocity = std::function<Point<Dim>(const Point<Dim>& place, const Point<Dim>& own)>;

  SideCover(const Grid<Dim>& grid, int axis, End end, const Point<Dim>& own)
      : grid_(grid), axis_(axis), end_(end), own_(own) {}

  int axis() const { return axis_; }
  End end() const { return end_; }
  /// What was last set becomes the moment before; the first time both are the same.
  void set(double time, const Velocity& velocity);
  double operator()(const Index<Dim>& face, int component, double time) const;

 private:
  struct Moment {
    double time = 0;
    Points<Dim> velocities;  ///< of each place of the plane, by component at that component's faces
  };
  Box<Dim> plane() const;
  std::size_t number(const Index<Dim>& face) const;

  const Grid<Dim>& grid_;
  int axis_;
  End end_;
  Point<Dim> own_;
  Moment before_, now_;
};

extern template class SideCover<2>;
extern template class SideCover<3>;

}  // namespace washfsi
