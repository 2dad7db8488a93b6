// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// The water inside a body whose walls are held by markers. It slips behind the walls as that before them does.
struct InnerWater {
  /// Whether the body only ever turns. Then it takes the water inside along, so that this has the body's inertia. Else
  /// the water is free: it is stirred by its slip, and has to find its way back.
  bool turns = false;
  double constrained_depth = 0;  ///< behind the walls, from which on the body holds it [m]

  /// `slides`: it is taken along by the water before the walls, as a law of their friction has it.
  template <int Dim>
  static InnerWater of(const Body<Dim>& body, const Grid<Dim>& grid, bool slides);
};

extern template InnerWater InnerWater::of<2>(const Body<2>&, const Grid<2>&, bool);
extern template InnerWater InnerWater::of<3>(const Body<3>&, const Grid<3>&, bool);

}  // namespace washfsi
