// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/contact.hpp"

namespace washfsi {

ContactOptions ContactOptions::from_options(Options& options) {
  ContactOptions contact;
  options.block("contact_", "Contact of cloth with bodies", [&](OptionBlock& block) {
    block.real("pressure", contact.pressure, "Pa", non_negative, "push on cloth at a body's surface; 0: none");
    block.real("distance", contact.distance, "m", positive, "distance from the surface at which the push begins");
  });
  return contact;
}

namespace {

// Force on a marker at this distance from a surface.
double push(const ContactOptions& contact, double area, double distance) {
  const double nearness = 1 - distance / contact.distance;
  return nearness > 0 ? contact.pressure * area * nearness * nearness : 0;
}

}  // namespace

template <int Dim>
Points<Dim> contact_forces(const ContactOptions& contact, const std::vector<Body<Dim>>& bodies,
                           const Boundary<Dim>& boundary, const Grid<Dim>& grid, const Cloths<Dim>& cloths,
                           const Points<Dim>& positions, double time, ContactLoads<Dim>& reactions) {
  Points<Dim> forces(positions.size(), Point<Dim>::Zero());
  if (contact.pressure == 0) return forces;
  const std::vector<double>& areas = cloths.marker_areas();
  const Point<Dim> middle = 0.5 * (grid.lower() + grid.upper());
  const PosedBodies<Dim> posed(bodies, time);
  for (std::size_t m = 0; m < positions.size(); ++m) {
    const Point<Dim> place = grid.folded(positions[m]);
    const auto push_out = [&](double size, const Point<Dim>& normal, const Point<Dim>& center, Load<Dim>& reaction) {
      const Point<Dim> force = size * normal;
      forces[m] += force;
      reaction.add(place - center, -force);
    };
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const double size = push(contact, areas[m], posed.distance(b, place));
      if (size > 0)
        push_out(size, posed.normal(b, place, 1e-3 * contact.distance), bodies[b].motion.center_at(time),
                 reactions.bodies[b]);
    }
    for (int axis = 0; axis < Dim; ++axis)
      for (const End end : {End::lower, End::upper}) {
        const BoundaryKind kind = boundary.side(axis, end).kind;
        if (kind != BoundaryKind::wall && kind != BoundaryKind::slip) continue;
        const bool upper = end == End::upper;
        const double distance =
            upper ? grid.upper()[axis] - positions[m][axis] : positions[m][axis] - grid.lower()[axis];
        const double size = push(contact, areas[m], distance);
        if (size > 0)
          push_out(size, (upper ? -1 : 1) * Point<Dim>::Unit(axis), middle,
                   reactions.sides[static_cast<std::size_t>(axis)][upper ? 1 : 0]);
      }
  }
  return forces;
}

template Points<2> contact_forces<2>(const ContactOptions&, const std::vector<Body<2>>&, const Boundary<2>&,
                                     const Grid<2>&, const Cloths<2>&, const Points<2>&, double, ContactLoads<2>&);
template Points<3> contact_forces<3>(const ContactOptions&, const std::vector<Body<3>>&, const Boundary<3>&,
                                     const Grid<3>&, const Cloths<3>&, const Points<3>&, double, ContactLoads<3>&);

}  // namespace washfsi
