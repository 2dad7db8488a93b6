// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/inner_water.hpp"

#include <cmath>

namespace washfsi {

namespace {

// In cells. Beyond the reach of the markers' deltas; and so deep that what is held does not hinder eddies behind walls.
constexpr double beyond_deltas = 2.5, beyond_eddies = 12;

// By samples of the distance, turned.
template <int Dim>
bool turns_in_itself(const Body<Dim>& body, const Grid<Dim>& grid) {
  if (body.motion.at_rest() || !body.motion.only_turns()) return false;
  constexpr int count = 7;
  constexpr double angle = 0.7, alike = 1e-3;  // rad, cells
  const auto turn = Pose<Dim>::at(Point<Dim>::Zero(), angle);
  const Point<Dim> corner = grid.lower() - body.motion.center, size = grid.upper() - grid.lower();
  Box<Dim> samples{};
  samples.upper.fill(count + 1);
  bool is_alike = true;
  for_each<Dim>(samples, [&](const Index<Dim>& n) {
    Point<Dim> place = corner;
    for (int d = 0; d < Dim; ++d) place[d] += size[d] * static_cast<double>(n[d]) / count;
    const double change = body.shape->distance(turn.in_space(place)) - body.shape->distance(place);
    is_alike = is_alike && std::abs(change) < alike * grid.spacing().minCoeff();
  });
  return is_alike;
}

}  // namespace

template <int Dim>
InnerWater InnerWater::of(const Body<Dim>& body, const Grid<Dim>& grid) {
  const bool along = turns_in_itself(body, grid);
  return {along, (along ? beyond_deltas : beyond_eddies) * grid.spacing().maxCoeff()};
}

template InnerWater InnerWater::of<2>(const Body<2>&, const Grid<2>&);
template InnerWater InnerWater::of<3>(const Body<3>&, const Grid<3>&);

}  // namespace washfsi
