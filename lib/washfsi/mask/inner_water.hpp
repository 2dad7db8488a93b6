// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// The water inside a body whose walls have markers. It slips behind the walls as the water before them does.
struct InnerWater {
  /// Whether the body only ever turns. Then the water inside turns with it and is part of its inertia. Else the water
  /// is free: its slip drives eddies, in which it flows back.
  bool turns = false;
  double constrained_depth = 0;  ///< depth behind the walls beyond which the water has the body's velocity [m]

  /// `slides`: whether the inner water moves with the water before the walls, under a law of friction.
  template <int Dim>
  static InnerWater of(const Body<Dim>& body, const Grid<Dim>& grid, bool slides);
};

extern template InnerWater InnerWater::of<2>(const Body<2>&, const Grid<2>&, bool);
extern template InnerWater InnerWater::of<3>(const Body<3>&, const Grid<3>&, bool);

}  // namespace washfsi
