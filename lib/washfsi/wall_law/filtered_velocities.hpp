// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/point.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// The velocities u_t of the water along the walls at two distances before each point, filtered in time by
///   T du_bar_t/dt = u_t - u_bar_t,    T = y/|u_t(y)| with y the larger distance,
/// implicit in time. The first flow starts the filter.
template <int Dim>
class FilteredVelocities {
 public:
  explicit FilteredVelocities(std::size_t points) : values_(of_each * points, Point<Dim>::Zero()) {}

  const Point<Dim>& far(std::size_t point) const { return values_[of_each * point]; }       ///< [m/s]
  const Point<Dim>& near(std::size_t point) const { return values_[of_each * point + 1]; }  ///< [m/s]
  /// Takes the velocities [m/s] of a flow a step of dt [s] after the last one; `distance` is that of the far one [m].
  void take(std::size_t point, const Point<Dim>& at_near, const Point<Dim>& at_far, double distance, double dt);
  /// Call it when all points have taken their first flow.
  void begin() { begun_ = true; }

  /// Registers the values of this rank's points, which begin with number `first` of `count` on all ranks. With other
  /// points the filter starts with the next flow.
  void register_state(StateList& state, std::size_t first, std::size_t count);

 private:
  static constexpr std::size_t of_each = 2;
  Points<Dim> values_;  ///< far, near of each point [m/s]
  bool begun_ = false;  ///< whether the values are of an earlier flow
};

extern template class FilteredVelocities<2>;
extern template class FilteredVelocities<3>;

}  // namespace washfsi
