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
}

template <int Dim>
void Cushion<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  for (const Plane& plane : planes_)
    of_groups[around_.cloths.group_number(plane.marker)] += push(plane, positions).energy;
}

template <int Dim>
void Cushion<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                   Points<Dim>& rates) const {
  for (const Plane& plane : planes_)
    rates[plane.marker] -= push(plane, positions).stiffness * plane.normal.dot(direction[plane.marker]) * plane.normal;
}

// One block for each marker, whether it touches anything or not: so the pattern never changes.
template <int Dim>
void Cushion<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness,
                                   const AddMarkerBlock<Dim>& add) const {
  std::vector<StiffnessBlock<Dim>> blocks(positions.size(), StiffnessBlock<Dim>::Zero());
  for (const Plane& plane : planes_)
    blocks[plane.marker] += push(plane, positions).stiffness * plane.normal * plane.normal.transpose();
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
void Cushion<Dim>::add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const {
  const Point<Dim> middle = 0.5 * (around_.grid.lower() + around_.grid.upper());
  for (const Plane& plane : planes_) {
    const Point<Dim> place = around_.grid.folded(positions[plane.marker]), reaction = -force(plane, positions);
    if (plane.body < loads.bodies.size())
      loads.bodies[plane.body].add(place - around_.bodies[plane.body].motion.center_at(time_), reaction);
    else
      loads.sides[plane.axis][plane.end == End::upper ? 1 : 0].add(place - middle, reaction);
  }
}

template class Cushion<2>;
template class Cushion<3>;

}  // namespace washfsi
