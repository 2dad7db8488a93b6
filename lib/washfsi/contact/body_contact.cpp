// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/body_contact.hpp"

#include <algorithm>

#include "washfsi/contact/plane_blocks.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

template <int Dim>
MakeForce<Dim> BodyContact<Dim>::maker(const BodyContactOptions& options) {
  return [options](const Surroundings<Dim>& surroundings) -> std::unique_ptr<MarkerForce<Dim>> {
    return options.pressure > 0 ? std::make_unique<BodyContact>(options, surroundings) : nullptr;
  };
}

template <int Dim>
BodyContact<Dim>::BodyContact(const BodyContactOptions& options, const Surroundings<Dim>& surroundings)
    : ContactPotential<Dim>(options.distance, options.friction, options.law == BodyContactLaw::barrier),
      options_(options),
      around_(surroundings),
      planes_(options, surroundings, ContactPotential<Dim>::distances()),
      friction_(options, surroundings.cloths) {}

template <int Dim>
void BodyContact<Dim>::begin_step(const StepStart<Dim>& start) {
  const Points<Dim> velocities = planes_.find(start);
  friction_.begin(start, velocities, planes_);
}

template <int Dim>
void BodyContact<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  const Points<Dim> all = planes_.with_halo(positions);
  for (const Plane& plane : planes_.list()) {
    const Point<Dim> force = planes_.push(plane, all).pressure * plane.normal;
    plane.visit_own([&](std::size_t i, std::size_t m) { forces[m] += plane.shares[i] * force; });
  }
  friction_.visit(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    plane.visit_own([&](std::size_t i, std::size_t m) { forces[m] -= plane.shares[i] * friction.pull; });
  });
}

template <int Dim>
void BodyContact<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  const Points<Dim> all = planes_.with_halo(positions);
  const auto add = [&](const Plane& plane, double energy) {
    if (plane.counts()) of_groups[around_.cloths.pieces()[plane.piece].group] += energy;
  };
  for (const Plane& plane : planes_.list()) add(plane, planes_.push(plane, all).energy);
  friction_.visit(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) { add(plane, friction.energy); });
}

template <int Dim>
void BodyContact<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                       Points<Dim>& rates) const {
  const Points<Dim> all = planes_.with_halo(positions), ways = planes_.with_halo(direction);
  const auto add = [&](const Plane& plane, const Point<Dim>& rate) {
    plane.visit_own([&](std::size_t i, std::size_t m) { rates[m] -= plane.shares[i] * rate; });
  };
  for (const Plane& plane : planes_.list())
    add(plane, planes_.push(plane, all).stiffness * plane.normal.dot(plane.place(ways)) * plane.normal);
  friction_.visit(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    add(plane, friction.stiffness * plane.place(ways));
  });
}

template <int Dim>
void BodyContact<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness,
                                       const AddMarkerBlock<Dim>& add) const {
  const Points<Dim> all = planes_.with_halo(positions);
  PlaneBlocks<Dim> blocks(positions.size(), planes_.finder());
  for (const Plane& plane : planes_.list())
    blocks.add(plane, planes_.push(plane, all).stiffness * plane.normal * plane.normal.transpose());
  friction_.visit(
      all, [&](const Plane& plane, const FrictionForce<Dim>& friction) { blocks.add(plane, friction.stiffness); });
  blocks.visit(around_.cloths, add);
}

// The bound for a marker on the surface; with the barrier, which is singular there, for one at a third of d^ or where
// the nearest one starts.
template <int Dim>
void BodyContact<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  double nearest = options_.law == BodyContactLaw::barrier ? options_.distance / 3 : 0;
  if (options_.law == BodyContactLaw::barrier)
    for (const Plane& plane : planes_.list())
      nearest = std::min(nearest, plane.distance * options_.distance / plane.begins);
  const BodyPush push = body_push(options_, nearest, options_.distance, ContactPlanes<Dim>::soft_start);
  for (StiffnessBound& bound : bounds) bound.stiffness += 0.25 * push.stiffness;
}

// A tenth of each distance remains. A soft barrier has no step limit.
template <int Dim>
double BodyContact<Dim>::step_limit(const Points<Dim>& from, const Points<Dim>& motion) {
  constexpr double kept = 0.1;
  const Points<Dim> starts = planes_.with_halo(from), ways = planes_.with_halo(motion);
  double part = 1;
  for (const Plane& plane : planes_.list()) {
    if (plane.soft > 0) continue;
    const double start = plane.gap(starts), nearer = -plane.normal.dot(plane.place(ways));
    if (nearer > (1 - kept) * start) part = std::min(part, (1 - kept) * start / nearer);
  }
  return -largest(around_.cloths.comm(), -part);
}

template <int Dim>
void BodyContact<Dim>::add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const {
  const Points<Dim> all = planes_.with_halo(positions);
  for (const Plane& plane : planes_.list()) {
    const double pressed = planes_.push(plane, all).pressure;
    plane.visit_own([&](std::size_t i, std::size_t m) {
      contact.normal_force[m] += plane.shares[i] * pressed;
      if (pressed > 0 && !plane.is_of_face()) contact.area[m] += plane.area;
    });
  }
  friction_.visit(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    plane.visit_own([&](std::size_t i, std::size_t m) {
      contact.friction_power[m] += plane.shares[i] * friction.work / friction_.dt();
    });
  });
}

template <int Dim>
void BodyContact<Dim>::add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const {
  const Points<Dim> all = planes_.with_halo(positions);
  for (const Plane& plane : planes_.list())
    add_reaction(plane, all, -planes_.push(plane, all).pressure * plane.normal, loads);
  friction_.visit(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    add_reaction(plane, all, friction.pull, loads);
  });
}

template <int Dim>
void BodyContact<Dim>::add_reaction(const Plane& plane, const Points<Dim>& all, const Point<Dim>& reaction,
                                    ContactLoads<Dim>& loads) const {
  if (!plane.counts()) return;
  const Point<Dim> place = around_.grid.folded(plane.place(all));
  const Point<Dim> middle = 0.5 * (around_.grid.lower() + around_.grid.upper());
  if (plane.body < loads.bodies.size())
    loads.bodies[plane.body].add(around_.bodies[plane.body].at(planes_.time()).arm(place), reaction);
  else
    loads.sides[plane.axis][plane.end == End::upper ? 1 : 0].add(place - middle, reaction);
}

// The tightest contact as its planes were found.
template <int Dim>
TightestContact BodyContact<Dim>::tightest() const {
  TightestContact tightest;
  for (const Plane& plane : planes_.list()) {
    const double share = plane.distance / plane.begins;
    if (share >= tightest.share) continue;
    const std::string thing = plane.body < around_.bodies.size() ? "body " + around_.bodies[plane.body].name
                                                                 : std::string("a side of the box");
    tightest = {share, around_.cloths.name_of(plane.piece) + " is " + format_text("%.3g m", plane.distance) + " from " +
                           thing + " at (" + list_text<Dim>(plane.start) + ") m"};
  }
  return tightest;
}

template class BodyContact<2>;
template class BodyContact<3>;

}  // namespace washfsi
