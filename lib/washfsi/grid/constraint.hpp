// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <petscvec.h>

#include "washfsi/grid/index.hpp"

namespace washfsi {

/// A face in fluid that has a neighbour in a solid along one axis: a wall is met on the way there.
template <int Dim>
struct CutFace {
  /// Where the stencil ends on one side: the wall, or the neighbour if that is fluid.
  struct Arm {
    bool cut = false;
    double length = 1;         ///< distance to the wall over the spacing, above 0 and at most 1
    double wall_velocity = 0;  ///< this component of the wall's velocity [m/s]
  };
  Index<Dim> face{};
  int component = 0, axis = 0;
  Arm lower, upper;
};

/// The constraint of the velocity by solids: a fraction H (1 in fluid, 0 in solid) and a velocity [m/s], on faces; null
/// vectors: no solids. If `cuts` is given, the viscous stencils of fluid faces beside solids end at the walls.
template <int Dim>
struct Constraint {
  Vec fluid_fraction = nullptr;
  Vec solid_velocity = nullptr;
  const std::vector<CutFace<Dim>>* cuts = nullptr;  ///< cut faces of this rank
  bool in_projection = false;                       ///< whether the projection contains H too (4.2-9)
};

}  // namespace washfsi
