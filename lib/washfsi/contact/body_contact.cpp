// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/body_contact.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

namespace {

constexpr double soft_start = 0.1;  // share of the contact distance: points that start nearer have a soft barrier
constexpr double sharper = 0.25;    // the next share over that within which the solution must not lie

}  // namespace

template <int Dim>
MakeForce<Dim> BodyContact<Dim>::maker(const BodyContactOptions& options) {
  return [options](const Surroundings<Dim>& surroundings) -> std::unique_ptr<MarkerForce<Dim>> {
    return options.pressure > 0 ? std::make_unique<BodyContact>(options, surroundings) : nullptr;
  };
}

template <int Dim>
BodyContact<Dim>::BodyContact(const BodyContactOptions& options, const Surroundings<Dim>& surroundings)
    : options_(options),
      around_(surroundings),
      distances_(options.distance),
      planes_near_(surroundings, options.law == BodyContactLaw::barrier) {}

template <int Dim>
Points<Dim> BodyContact<Dim>::with_halo(const Points<Dim>& values) const {
  if (!has_faces_) return values;
  Points<Dim> all = values;
  const Points<Dim> halo = around_.cloths.with_halo(values);
  all.insert(all.end(), halo.begin(), halo.end());
  return all;
}

template <int Dim>
void BodyContact<Dim>::find_whether_faces_touch() {
  has_faces_ = any_rank(around_.cloths.comm(), std::ranges::any_of(planes_, &Plane::is_of_face));
}

template <int Dim>
void BodyContact<Dim>::begin_step(const StepStart<Dim>& start) {
  time_ = start.time;
  has_faces_ = planes_near_.sees_faces();
  const Points<Dim> all = with_halo(start.positions), velocities = with_halo(start.velocities);
  std::vector<double> speeds;
  for (const auto& velocity : velocities) speeds.push_back(velocity.norm());
  planes_ = planes_near_.find(all, speeds, options_.distance, time_, start.dt);
  find_whether_faces_touch();
  follow_distances();
  for (Plane& plane : planes_) plane.soft = plane.distance < soft_start * plane.begins ? soft_start : 0;
  begin_friction(start, velocities);
}

// Only a barrier is so stiff that it would throw off cloth that starts within it.
template <int Dim>
void BodyContact<Dim>::follow_distances() {
  if (options_.law != BodyContactLaw::barrier) return;
  const std::size_t cloths = around_.cloths.pieces().size(), bodies = around_.bodies.size();
  const bool starts = !distances_.has_started();
  if (starts || !distances_.less().empty()) {
    PairDistances::Nearest nearest;
    for (const Plane& plane : planes_)
      if (const double now = plane.before * options_.distance / plane.begins; now < options_.distance)
        note(nearest, plane.piece, plane.thing(cloths, bodies), now);
    if (starts)
      distances_.start(around_.cloths.comm(), nearest);
    else
      distances_.follow(around_.cloths.comm(), nearest, options_.distance);
  }
  for (Plane& plane : planes_) plane.begins *= begins_over_usual(plane);
}

template <int Dim>
double BodyContact<Dim>::begins_over_usual(const Plane& plane) const {
  if (distances_.less().empty()) return 1;
  return distances_.of(plane.piece, plane.thing(around_.cloths.pieces().size(), around_.bodies.size())) /
         options_.distance;
}

template <int Dim>
bool BodyContact<Dim>::sharpen(const Points<Dim>& positions) {
  if (options_.law != BodyContactLaw::barrier) return false;
  has_faces_ = planes_near_.sees_faces();
  const Points<Dim> all = with_halo(positions);
  const bool is_harder = soften_less(all), is_denser = add_missed(all);
  find_whether_faces_touch();
  return any_rank(around_.cloths.comm(), is_harder || is_denser);
}

// The barrier begins to be soft nearer to the surface where the solution lies deep in its soft part.
template <int Dim>
bool BodyContact<Dim>::soften_less(const Points<Dim>& all) {
  bool is_harder = false;
  for (Plane& plane : planes_) {
    const double least = sharper * plane.soft;
    if (plane.soft == 0 || plane.gap(all) >= least * plane.begins) continue;
    plane.soft = least;
    is_harder = true;
  }
  return is_harder;
}

// Adds planes where faces have come nearer to bodies than their planes show, as they turn about the place of these.
template <int Dim>
bool BodyContact<Dim>::add_missed(const Points<Dim>& all) {
  if (!planes_near_.sees_faces()) return false;
  const double within = soft_start * TangentPlanes<Dim>::of_faces * options_.distance;
  std::vector<Plane> missed = planes_near_.missed(planes_, all, options_.distance, within, time_);
  for (Plane& plane : missed) {
    plane.begins *= begins_over_usual(plane);
    plane.soft = soft_start;
  }
  planes_.insert(planes_.end(), missed.begin(), missed.end());
  return !missed.empty();
}

// Uses the normal forces of the step's start; with dt = 0 nothing slides. In an explicit step markers and surfaces
// slide as they do at its start.
template <int Dim>
void BodyContact<Dim>::begin_friction(const StepStart<Dim>& start, const Points<Dim>& velocities) {
  sliding_.clear();
  const bool held = start.lagged.dt > 0;
  const double dt = held ? start.lagged.dt : start.dt, damping = held ? 0 : options_.damping;
  std::vector<FrictionPair<Dim>> pairs;
  if (dt > 0 && (options_.friction > 0 || damping > 0))
    for (const Plane& plane : planes_) {
      const BodyPush before = push(plane, plane.before);
      if (before.pressure == 0) continue;
      const double limit = options_.friction * before.pressure;
      const Point<Dim> way = dt * planes_near_.velocity_of_surface(plane, time_ - 0.5 * start.dt);
      sliding_.push_back({plane, held ? Point<Dim>(way - dt * plane.place(velocities)) : way});
      double mobility = 0;
      if (held)
        visit_own(plane,
                  [&](std::size_t, std::size_t m) { mobility = std::max(mobility, start.lagged.mobilities[m]); });
      const double mass = plane.area * around_.cloths.group_of_piece(plane.piece).excess_mass;
      pairs.push_back(
          {plane.normal, limit, 2 * dt * dt * limit * mobility, contact_damping(damping, before.stiffness, mass)});
    }
  friction_.begin(std::move(pairs), dt, start.share);
}

template <int Dim>
Points<Dim> BodyContact<Dim>::ways(const Points<Dim>& all) const {
  Points<Dim> ways;
  for (const SlidingPoint& sliding : sliding_)
    ways.push_back(sliding.plane.place(all) - sliding.plane.start - sliding.way);
  return ways;
}

// Calls visit(plane, friction force there).
template <int Dim>
template <class Visit>
void BodyContact<Dim>::visit_friction(const Points<Dim>& all, const Visit& visit) const {
  const std::vector<FrictionForce<Dim>> forces = friction_.forces(ways(all));
  for (std::size_t r = 0; r < forces.size(); ++r) visit(sliding_[r].plane, forces[r]);
}

// Calls visit(index among the plane's markers, index among this rank's).
template <int Dim>
template <class Visit>
void BodyContact<Dim>::visit_own(const Plane& plane, const Visit& visit) const {
  for (std::size_t i = 0; i < plane.count(); ++i)
    if (plane.own[i] != SeenFaces<Dim>::none) visit(i, static_cast<std::size_t>(plane.own[i]));
}

// The push on the area that the point stands for.
template <int Dim>
BodyPush BodyContact<Dim>::push(const Plane& plane, double gap) const {
  const BodyPush push = body_push(options_, gap, plane.begins, plane.soft);
  return {plane.area * push.energy, plane.area * push.pressure, plane.area * push.stiffness};
}

template <int Dim>
void BodyContact<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  const Points<Dim> all = with_halo(positions);
  for (const Plane& plane : planes_) {
    const Point<Dim> force = push(plane, all).pressure * plane.normal;
    visit_own(plane, [&](std::size_t i, std::size_t m) { forces[m] += plane.shares[i] * force; });
  }
  visit_friction(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    visit_own(plane, [&](std::size_t i, std::size_t m) { forces[m] -= plane.shares[i] * friction.pull; });
  });
}

template <int Dim>
void BodyContact<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  const Points<Dim> all = with_halo(positions);
  const auto add = [&](const Plane& plane, double energy) {
    if (plane.counts()) of_groups[around_.cloths.pieces()[plane.piece].group] += energy;
  };
  for (const Plane& plane : planes_) add(plane, push(plane, all).energy);
  visit_friction(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) { add(plane, friction.energy); });
}

template <int Dim>
void BodyContact<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                       Points<Dim>& rates) const {
  const Points<Dim> all = with_halo(positions), ways = with_halo(direction);
  const auto add = [&](const Plane& plane, const Point<Dim>& rate) {
    visit_own(plane, [&](std::size_t i, std::size_t m) { rates[m] -= plane.shares[i] * rate; });
  };
  for (const Plane& plane : planes_)
    add(plane, push(plane, all).stiffness * plane.normal.dot(plane.place(ways)) * plane.normal);
  visit_friction(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    add(plane, friction.stiffness * plane.place(ways));
  });
}

// Visits one block for each marker, and for each two of a face, whether they touch anything or not: so the pattern
// never changes.
template <int Dim>
void BodyContact<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness,
                                       const AddMarkerBlock<Dim>& add) const {
  const Points<Dim> all = with_halo(positions);
  using Block = StiffnessBlock<Dim>;
  const auto& faces = planes_near_.faces().list();
  std::vector<Block> of_markers(positions.size(), Block::Zero());
  std::vector<std::array<Block, Dim * Dim>> of_faces(planes_near_.sees_faces() ? faces.size() : 0);
  for (auto& blocks : of_faces) blocks.fill(Block::Zero());
  const auto add_block = [&](const Plane& plane, const Block& block) {
    if (!plane.is_of_face()) {
      of_markers[plane.markers[0]] += block;
    } else {
      for (std::size_t i = 0; i < Dim; ++i)
        for (std::size_t j = 0; j < Dim; ++j)
          of_faces[plane.face][i * Dim + j] += plane.shares[i] * plane.shares[j] * block;
    }
  };
  for (const Plane& plane : planes_)
    add_block(plane, push(plane, all).stiffness * plane.normal * plane.normal.transpose());
  visit_friction(all,
                 [&](const Plane& plane, const FrictionForce<Dim>& friction) { add_block(plane, friction.stiffness); });
  for (std::size_t m = 0; m < of_markers.size(); ++m)
    add(around_.cloths.number_of(m), around_.cloths.number_of(m), of_markers[m]);
  for (std::size_t f = 0; f < of_faces.size(); ++f)
    for (std::size_t i = 0; i < Dim; ++i)
      for (std::size_t j = 0; j < Dim; ++j)
        if (faces[f].own[i] != SeenFaces<Dim>::none)
          add(faces[f].numbers[i], faces[f].numbers[j], of_faces[f][i * Dim + j]);
}

// The bound for a marker on the surface; with the barrier, which is singular there, for one at a third of d0 or where
// the nearest one starts.
template <int Dim>
void BodyContact<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  double nearest = options_.law == BodyContactLaw::barrier ? options_.distance / 3 : 0;
  if (options_.law == BodyContactLaw::barrier)
    for (const Plane& plane : planes_) nearest = std::min(nearest, plane.distance * options_.distance / plane.begins);
  const BodyPush push = body_push(options_, nearest, options_.distance, soft_start);
  for (StiffnessBound& bound : bounds) bound.stiffness += 0.25 * push.stiffness;
}

// A tenth of each distance remains. A soft barrier has no step limit.
template <int Dim>
double BodyContact<Dim>::step_limit(const Points<Dim>& from, const Points<Dim>& motion) {
  constexpr double kept = 0.1;
  const Points<Dim> starts = with_halo(from), ways = with_halo(motion);
  double part = 1;
  for (const Plane& plane : planes_) {
    if (plane.soft > 0) continue;
    const double start = plane.gap(starts), nearer = -plane.normal.dot(plane.place(ways));
    if (nearer > (1 - kept) * start) part = std::min(part, (1 - kept) * start / nearer);
  }
  return -largest(around_.cloths.comm(), -part);
}

template <int Dim>
void BodyContact<Dim>::add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const {
  const Points<Dim> all = with_halo(positions);
  for (const Plane& plane : planes_) {
    const double pressed = push(plane, all).pressure;
    visit_own(plane, [&](std::size_t i, std::size_t m) {
      contact.normal_force[m] += plane.shares[i] * pressed;
      if (pressed > 0 && !plane.is_of_face()) contact.area[m] += plane.area;
    });
  }
  visit_friction(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    visit_own(plane, [&](std::size_t i, std::size_t m) {
      contact.friction_power[m] += plane.shares[i] * friction.work / friction_.dt();
    });
  });
}

template <int Dim>
void BodyContact<Dim>::add_reactions(const Points<Dim>& positions, ContactLoads<Dim>& loads) const {
  const Points<Dim> all = with_halo(positions);
  for (const Plane& plane : planes_) add_reaction(plane, all, -push(plane, all).pressure * plane.normal, loads);
  visit_friction(all, [&](const Plane& plane, const FrictionForce<Dim>& friction) {
    add_reaction(plane, all, friction.pull, loads);
  });
}

template <int Dim>
void BodyContact<Dim>::add_reaction(const Plane& plane, const Points<Dim>& all, const Point<Dim>& reaction,
                                    ContactLoads<Dim>& loads) const {
  if (!plane.counts()) return;
  const Point<Dim> place = around_.grid.folded(plane.place(all));
  if (plane.body < loads.bodies.size())
    loads.bodies[plane.body].add(around_.bodies[plane.body].at(time_).arm(place), reaction);
  else
    loads.sides[plane.axis][plane.end == End::upper ? 1 : 0].add(place - middle(), reaction);
}

// The tightest contact as its planes were found.
template <int Dim>
TightestContact BodyContact<Dim>::tightest() const {
  TightestContact tightest;
  for (const Plane& plane : planes_) {
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
