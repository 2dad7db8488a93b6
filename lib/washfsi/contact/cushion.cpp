// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/cushion.hpp"

namespace washfsi {

CushionOptions CushionOptions::from_options(Options& options) {
  CushionOptions cushion;
  options.block("contact_", "Contact of cloth with bodies", [&](OptionBlock& block) {
    block.real("pressure", cushion.pressure, "Pa", non_negative, "push on cloth at a body's surface; 0: none");
    block.real("distance", cushion.distance, "m", positive, "distance from the surface at which the push begins");
  });
  return cushion;
}

template <int Dim>
MakeForce<Dim> Cushion<Dim>::from_options(Options& options) {
  return maker(CushionOptions::from_options(options));
}

template <int Dim>
MakeForce<Dim> Cushion<Dim>::maker(const CushionOptions& options) {
  return [options](const Surroundings<Dim>& surroundings) -> std::unique_ptr<MarkerForce<Dim>> {
    return options.pressure > 0 ? std::make_unique<Cushion>(options, surroundings) : nullptr;
  };
}

template <int Dim>
Cushion<Dim>::Cushion(const CushionOptions& options, const Surroundings<Dim>& surroundings)
    : options_(options), around_(surroundings) {}

template <int Dim>
void Cushion<Dim>::begin_step(const StepStart<Dim>& start) {
  time_ = start.time;
  planes_.clear();
  const PosedBodies<Dim> posed(around_.bodies, time_);
  for (std::size_t m = 0; m < start.positions.size(); ++m) {
    // what the marker may come near to in the step, with as much to spare
    const double reach =
        start.dt > 0 ? 2 * (options_.distance + start.dt * start.velocities[m].norm()) : options_.distance;
    find_bodies(posed, m, start.positions[m], reach);
    find_sides(m, start.positions[m], reach);
  }
}

template <int Dim>
void Cushion<Dim>::find_bodies(const PosedBodies<Dim>& posed, std::size_t marker, const Point<Dim>& start,
                               double reach) {
  const Point<Dim> place = around_.grid.folded(start);
  for (std::size_t b = 0; b < posed.size(); ++b) {
    const double distance = posed.distance(b, place);
    if (distance < reach)
      planes_.push_back({marker, start, posed.normal(b, place, 1e-3 * options_.distance), distance, b});
  }
}

template <int Dim>
void Cushion<Dim>::find_sides(std::size_t marker, const Point<Dim>& start, double reach) {
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : {End::lower, End::upper}) {
      const BoundaryKind kind = around_.boundary.side(axis, end).kind;
      if (kind != BoundaryKind::wall && kind != BoundaryKind::slip) continue;
      const bool upper = end == End::upper;
      const double distance =
          upper ? around_.grid.upper()[axis] - start[axis] : start[axis] - around_.grid.lower()[axis];
      if (distance < reach)
        planes_.push_back(
            {marker, start, (upper ? -1 : 1) * Point<Dim>::Unit(axis), distance, around_.bodies.size(), axis, end});
    }
}

// s, not below 0
template <int Dim>
double Cushion<Dim>::nearness(const Plane& plane, const Points<Dim>& positions) const {
  const double distance = plane.distance + plane.normal.dot(positions[plane.marker] - plane.start);
  return std::max(0.0, 1 - distance / options_.distance);
}

template <int Dim>
Point<Dim> Cushion<Dim>::push(const Plane& plane, const Points<Dim>& positions) const {
  const double s = nearness(plane, positions), area = around_.cloths.marker_areas()[plane.marker];
  return options_.pressure * area * s * s * plane.normal;
}

template <int Dim>
double Cushion<Dim>::stiffness(const Plane& plane, const Points<Dim>& positions) const {
  const double area = around_.cloths.marker_areas()[plane.marker];
  return 2 * options_.pressure * area / options_.distance * nearness(plane, positions);
}

template <int Dim>
void Cushion<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  for (const Plane& plane : planes_) forces[plane.marker] += push(plane, positions);
}

template <int Dim>
void Cushion<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  const Cloths<Dim>& cloths = around_.cloths;
  for (const Plane& plane : planes_) {
    const double s = nearness(plane, positions);
    of_groups[cloths.group_number(plane.marker)] +=
        options_.pressure * cloths.marker_areas()[plane.marker] * options_.distance / 3 * s * s * s;
  }
}

template <int Dim>
void Cushion<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                   Points<Dim>& rates) const {
  for (const Plane& plane : planes_)
    rates[plane.marker] -= stiffness(plane, positions) * plane.normal.dot(direction[plane.marker]) * plane.normal;
}

// One block for each marker, whether it touches anything or not: so the pattern never changes.
template <int Dim>
void Cushion<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness,
                                   const AddMarkerBlock<Dim>& add) const {
  std::vector<StiffnessBlock<Dim>> blocks(positions.size(), StiffnessBlock<Dim>::Zero());
  for (const Plane& plane : planes_)
    blocks[plane.marker] += stiffness(plane, positions) * plane.normal * plane.normal.transpose();
  for (std::size_t m = 0; m < blocks.size(); ++m) {
    const PetscInt marker = around_.cloths.number_of(m);
    add(marker, marker, blocks[m]);
  }
}

// Of a marker on the surface.
template <int Dim>
void Cushion<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  for (StiffnessBound& bound : bounds) bound.stiffness += 0.25 * 2 * options_.pressure / options_.distance;
}

template <int Dim>
void Cushion<Dim>::add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const {
  const Point<Dim> middle = 0.5 * (around_.grid.lower() + around_.grid.upper());
  for (const Plane& plane : planes_) {
    const Point<Dim> place = around_.grid.folded(positions[plane.marker]), force = push(plane, positions);
    if (plane.body < loads.bodies.size())
      loads.bodies[plane.body].add(place - around_.bodies[plane.body].motion.center_at(time_), -force);
    else
      loads.sides[plane.axis][plane.end == End::upper ? 1 : 0].add(place - middle, -force);
  }
}

template class Cushion<2>;
template class Cushion<3>;

}  // namespace washfsi
