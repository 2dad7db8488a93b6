// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/touch_friction.hpp"

#include <algorithm>

namespace washfsi {

template <int Dim>
void TouchFriction<Dim>::begin_step(const StepStart<Dim>& start, const BarrierTouches<Dim>& near,
                                    const Points<Dim>& all) {
  if (start.dt != 0) return this->begin(pairs(near, all, damping_), all, start.dt, start.share);
  if (start.lagged.dt == 0 || coefficient_ == 0) return this->begin({}, all, 0);
  const NearMarkers<Dim>& known = near.search().known();
  this->begin_explicit(pairs(near, all, 0), known, all, known.values(start.velocities),
                       known.values(start.lagged.mobilities), start.lagged.dt);
}

// The friction pairs: what touches now.
template <int Dim>
std::vector<typename PairFriction<Dim>::Pair> TouchFriction<Dim>::pairs(const BarrierTouches<Dim>& near,
                                                                        const Points<Dim>& all, double damping) const {
  std::vector<Pair> pairs;
  if (coefficient_ > 0 || damping > 0)
    for (const Touch<Dim>& touch : near.at(all))
      if (touch.pressing > 0)
        pairs.push_back({touch.facing, coefficient_ * touch.pressing,
                         contact_damping(damping, touch.stiffness, mass_of(touch, near.search().known()))});
  return pairs;
}

// Mass of the lighter cloth on the area of the touch [kg].
template <int Dim>
double TouchFriction<Dim>::mass_of(const Touch<Dim>& touch, const NearMarkers<Dim>& known) const {
  const auto of_cloth = [&](std::size_t marker) { return cloths_.group_of_piece(known.piece_of(marker)).excess_mass; };
  const auto& markers = touch.facing.markers;
  return touch.area * std::min(of_cloth(markers[0]), of_cloth(markers[touch.facing.count - 1]));
}

template class TouchFriction<2>;
template class TouchFriction<3>;

}  // namespace washfsi
