// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/inner_water.hpp"

namespace washfsi {

namespace {

// Depths in cells: beyond the reach of the markers' deltas; and so deep that the constraint does not hinder eddies
// behind the walls.
constexpr double beyond_deltas = 2.5, beyond_eddies = 12;

}  // namespace

template <int Dim>
InnerWater InnerWater::of(const Body<Dim>& body, const Grid<Dim>& grid, bool slides) {
  const bool turns = !body.motion.at_rest() && body.motion.only_turns();
  return {turns, (turns || slides ? beyond_deltas : beyond_eddies) * grid.spacing().maxCoeff()};
}

template InnerWater InnerWater::of<2>(const Body<2>&, const Grid<2>&, bool);
template InnerWater InnerWater::of<3>(const Body<3>&, const Grid<3>&, bool);

}  // namespace washfsi
