// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/contact.hpp"

#include <cmath>

namespace washfsi {

namespace {

// Unit gradient of the signed distance, by central differences over a small part of the contact distance.
template <int Dim>
Point<Dim> outward_normal(const Body<Dim>& body, const Point<Dim>& place, double time, double step) {
  Point<Dim> gradient;
  for (int d = 0; d < Dim; ++d) {
    const Point<Dim> shift = step * Point<Dim>::Unit(d);
    gradient[d] = body.distance(place + shift, time) - body.distance(place - shift, time);
  }
  const double length = gradient.norm();
  return length > 0 ? Point<Dim>(gradient / length) : Point<Dim>::Zero();
}

}  // namespace

ContactOptions ContactOptions::from_options(Options& options) {
  ContactOptions contact;
  options.block("contact_", "Contact of cloth with bodies", [&](OptionBlock& block) {
    block.real("pressure", contact.pressure, "Pa", non_negative, "push on cloth at a body's surface; 0: none");
    block.real("distance", contact.distance, "m", positive, "distance from the surface at which the push begins");
  });
  return contact;
}

template <int Dim>
Points<Dim> contact_forces(const ContactOptions& contact, const std::vector<Body<Dim>>& bodies,
                           const Cloths<Dim>& cloths, const Points<Dim>& positions, double time,
                           std::vector<Load<Dim>>& reactions) {
  Points<Dim> forces(positions.size(), Point<Dim>::Zero());
  if (contact.pressure == 0) return forces;
  const std::vector<double>& areas = cloths.marker_areas();
  for (std::size_t m = 0; m < positions.size(); ++m)
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const double nearness = 1 - bodies[b].distance(positions[m], time) / contact.distance;
      if (nearness <= 0) continue;
      const Point<Dim> normal = outward_normal(bodies[b], positions[m], time, 1e-3 * contact.distance);
      const Point<Dim> force = contact.pressure * areas[m] * nearness * nearness * normal;
      forces[m] += force;
      reactions[b].force -= force;
      reactions[b].torque -= cross<Dim>(positions[m] - bodies[b].motion.center_at(time), force);
    }
  return forces;
}

template Points<2> contact_forces<2>(const ContactOptions&, const std::vector<Body<2>>&, const Cloths<2>&,
                                     const Points<2>&, double, std::vector<Load<2>>&);
template Points<3> contact_forces<3>(const ContactOptions&, const std::vector<Body<3>>&, const Cloths<3>&,
                                     const Points<3>&, double, std::vector<Load<3>>&);

}  // namespace washfsi
