// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/body_friction.hpp"

#include <algorithm>

namespace washfsi {

template <int Dim>
void BodyFriction<Dim>::begin(const StepStart<Dim>& start, const Points<Dim>& velocities,
                              const ContactPlanes<Dim>& planes) {
  sliding_.clear();
  const bool held = start.lagged.dt > 0;
  const double dt = held ? start.lagged.dt : start.dt;
  std::vector<FrictionPair<Dim>> pairs;
  if (dt > 0 && (coefficient_ > 0 || (!held && damping_ > 0)))
    for (const TangentPlane<Dim>& plane : planes.list()) {
      const BodyPush before = planes.push(plane, plane.before);
      if (before.pressure == 0) continue;
      const Point<Dim> way = dt * planes.finder().velocity_of_surface(plane, start.time - 0.5 * start.dt);
      sliding_.push_back({plane, held ? Point<Dim>(way - dt * plane.place(velocities)) : way});
      pairs.push_back(pair(plane, before, start));
    }
  friction_.begin(std::move(pairs), dt, start.share);
}

// The friction pair of a plane with this push at the step's start.
template <int Dim>
FrictionPair<Dim> BodyFriction<Dim>::pair(const TangentPlane<Dim>& plane, const BodyPush& before,
                                          const StepStart<Dim>& start) const {
  const bool held = start.lagged.dt > 0;
  const double limit = coefficient_ * before.pressure;
  double mobility = 0;
  if (held)
    plane.visit_own([&](std::size_t, std::size_t m) { mobility = std::max(mobility, start.lagged.mobilities[m]); });
  const double stops = 2 * start.lagged.dt * start.lagged.dt * limit * mobility;
  const double mass = plane.area * cloths_.group_of_piece(plane.piece).excess_mass;
  return {plane.normal, limit, stops, contact_damping(held ? 0 : damping_, before.stiffness, mass)};
}

template <int Dim>
Points<Dim> BodyFriction<Dim>::ways(const Points<Dim>& all) const {
  Points<Dim> ways;
  for (const SlidingPoint& sliding : sliding_)
    ways.push_back(sliding.plane.place(all) - sliding.plane.start - sliding.way);
  return ways;
}

template class BodyFriction<2>;
template class BodyFriction<3>;

}  // namespace washfsi
