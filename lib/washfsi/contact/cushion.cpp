// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/cushion.hpp"

#include <algorithm>

#include "washfsi/contact/barrier_function.hpp"

namespace washfsi {

namespace {

// The barrier, below a tenth of its distance as a parabola with the same second derivative.
BarrierValue softened_barrier(double s) {
  constexpr double soft = 0.1;
  if (s >= soft) return barrier(s);
  const BarrierValue from = barrier(soft);
  const double beyond = s - soft;
  return {from.value + from.first * beyond + 0.5 * from.second * beyond * beyond, from.first + from.second * beyond,
          from.second};
}

}  // namespace

CushionPush cushion_push(const CushionOptions& options, double distance) {
  const double p = options.pressure, d = options.distance;
  if (options.law == CushionLaw::barrier) {
    const BarrierValue b = softened_barrier(distance / d);
    return {p * d * b.value, -p * b.first, p / d * b.second};
  }
  const double s = std::max(0.0, 1 - distance / d);
  return {p * d / 3 * s * s * s, p * s * s, 2 * p / d * s};
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
  begin_friction(start);
}

// With the normal forces of the step's start; in no time nothing slides. In an explicit step markers and surfaces slide
// as they do at its start.
template <int Dim>
void Cushion<Dim>::begin_friction(const StepStart<Dim>& start) {
  rubbing_.clear();
  const bool held = start.held.dt > 0;
  const double dt = held ? start.held.dt : start.dt;
  std::vector<Rub<Dim>> rubs;
  if (options_.friction > 0 && dt > 0) {
    const PosedBodies<Dim> posed(around_.bodies, time_ - start.dt);
    for (Plane plane : planes_) {
      if (plane.body < posed.size()) plane.distance = posed.distance(plane.body, around_.grid.folded(plane.start));
      const double limit = options_.friction * push(plane, start.positions).pressure;
      if (limit == 0) continue;
      const Point<Dim> way = dt * velocity_of_surface(plane, time_ - 0.5 * start.dt);
      rubbing_.push_back({plane, held ? Point<Dim>(way - dt * start.velocities[plane.marker]) : way});
      rubs.push_back({plane.normal, limit, held ? 2 * dt * dt * limit * start.held.mobilities[plane.marker] : 0});
    }
  }
  friction_.begin(std::move(rubs), dt, start.share);
}

template <int Dim>
Point<Dim> Cushion<Dim>::velocity_of_surface(const Plane& plane, double time) const {
  const Point<Dim> place = around_.grid.folded(plane.start);
  if (plane.body < around_.bodies.size()) return around_.bodies[plane.body].motion.velocity(place, time);
  const Side<Dim>& side = around_.boundary.side(plane.axis, plane.end);
  return side.motion ? side.motion(place, time) : side.velocity;
}

template <int Dim>
Points<Dim> Cushion<Dim>::ways(const Points<Dim>& positions) const {
  Points<Dim> ways;
  for (const Rubbing& rubbing : rubbing_)
    ways.push_back(positions[rubbing.plane.marker] - rubbing.plane.start - rubbing.way);
  return ways;
}

// visit(plane, what friction does there)
template <int Dim>
template <class Visit>
void Cushion<Dim>::visit_rubs(const Points<Dim>& positions, const Visit& visit) const {
  const std::vector<RubForce<Dim>> forces = friction_.forces(ways(positions));
  for (std::size_t r = 0; r < forces.size(); ++r) visit(rubbing_[r].plane, forces[r]);
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

// Of a marker with this undeformed area.
template <int Dim>
CushionPush Cushion<Dim>::push(const Plane& plane, const Points<Dim>& positions) const {
  const double distance = plane.distance + plane.normal.dot(positions[plane.marker] - plane.start);
  const double area = around_.cloths.marker_areas()[plane.marker];
  const CushionPush push = cushion_push(options_, distance);
  return {area * push.energy, area * push.pressure, area * push.stiffness};
}

template <int Dim>
Point<Dim> Cushion<Dim>::force(const Plane& plane, const Points<Dim>& positions) const {
  return push(plane, positions).pressure * plane.normal;
}

template <int Dim>
void Cushion<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  for (const Plane& plane : planes_) forces[plane.marker] += force(plane, positions);
  visit_rubs(positions, [&](const Plane& plane, const RubForce<Dim>& rub) { forces[plane.marker] -= rub.pull; });
}

template <int Dim>
void Cushion<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  for (const Plane& plane : planes_)
    of_groups[around_.cloths.group_number(plane.marker)] += push(plane, positions).energy;
  visit_rubs(positions, [&](const Plane& plane, const RubForce<Dim>& rub) {
    of_groups[around_.cloths.group_number(plane.marker)] += rub.energy;
  });
}

template <int Dim>
void Cushion<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                   Points<Dim>& rates) const {
  for (const Plane& plane : planes_)
    rates[plane.marker] -= push(plane, positions).stiffness * plane.normal.dot(direction[plane.marker]) * plane.normal;
  visit_rubs(positions, [&](const Plane& plane, const RubForce<Dim>& rub) {
    rates[plane.marker] -= rub.stiffness * direction[plane.marker];
  });
}

// One block for each marker, whether it touches anything or not: so the pattern never changes.
template <int Dim>
void Cushion<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness,
                                   const AddMarkerBlock<Dim>& add) const {
  std::vector<StiffnessBlock<Dim>> blocks(positions.size(), StiffnessBlock<Dim>::Zero());
  for (const Plane& plane : planes_)
    blocks[plane.marker] += push(plane, positions).stiffness * plane.normal * plane.normal.transpose();
  visit_rubs(positions, [&](const Plane& plane, const RubForce<Dim>& rub) { blocks[plane.marker] += rub.stiffness; });
  for (std::size_t m = 0; m < blocks.size(); ++m) {
    const PetscInt marker = around_.cloths.number_of(m);
    add(marker, marker, blocks[m]);
  }
}

// Of a marker on the surface; of the barrier, which grows so much, at a third of d0, or where the nearest one starts.
template <int Dim>
void Cushion<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  double nearest = options_.law == CushionLaw::barrier ? options_.distance / 3 : 0;
  if (options_.law == CushionLaw::barrier)
    for (const Plane& plane : planes_) nearest = std::min(nearest, plane.distance);
  for (StiffnessBound& bound : bounds) bound.stiffness += 0.25 * cushion_push(options_, nearest).stiffness;
}

template <int Dim>
void Cushion<Dim>::add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const {
  for (const Plane& plane : planes_) {
    const double pressed = push(plane, positions).pressure;
    contact.normal_force[plane.marker] += pressed;
    if (pressed > 0) contact.area[plane.marker] += around_.cloths.marker_areas()[plane.marker];
  }
  visit_rubs(positions, [&](const Plane& plane, const RubForce<Dim>& rub) {
    contact.friction_power[plane.marker] += rub.work / friction_.dt();
  });
}

template <int Dim>
void Cushion<Dim>::add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const {
  for (const Plane& plane : planes_) add_reaction(plane, positions, -force(plane, positions), loads);
  visit_rubs(positions,
             [&](const Plane& plane, const RubForce<Dim>& rub) { add_reaction(plane, positions, rub.pull, loads); });
}

template <int Dim>
void Cushion<Dim>::add_reaction(const Plane& plane, const Points<Dim>& positions, const Point<Dim>& reaction,
                                ContactLoads<Dim>& loads) const {
  const Point<Dim> place = around_.grid.folded(positions[plane.marker]);
  if (plane.body < loads.bodies.size())
    loads.bodies[plane.body].add(place - around_.bodies[plane.body].motion.center_at(time_), reaction);
  else
    loads.sides[plane.axis][plane.end == End::upper ? 1 : 0].add(place - middle(), reaction);
}

template class Cushion<2>;
template class Cushion<3>;

}  // namespace washfsi
