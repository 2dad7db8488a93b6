// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/contact/barrier_function.hpp"
#include "washfsi/contact/collision.hpp"
#include "washfsi/contact/distance_curvature.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

namespace {

constexpr double most_ways = 2;  // largest motion of a marker at a time, in spacings

}  // namespace

template <int Dim>
MakeForce<Dim> Barrier<Dim>::maker(const BarrierOptions& options) {
  return [options](const Surroundings<Dim>& surroundings) -> std::unique_ptr<MarkerForce<Dim>> {
    if (surroundings.cloths.marker_count() == 0) return nullptr;
    return std::make_unique<Barrier>(options, surroundings);
  };
}

template <int Dim>
Barrier<Dim>::Barrier(const BarrierOptions& options, const Surroundings<Dim>& surroundings)
    : options_(options),
      around_(surroundings),
      spacing_(least_spacing(surroundings.cloths)),
      near_(options.stiffness, barrier_distance(options, surroundings.cloths), surroundings.cloths,
            periods_of<Dim>(surroundings.grid)),
      places_of_blocks_(surroundings.cloths) {
  places_of_blocks_.lay_out(near_, {});
}

// For the forces at the start, the search for the end of the previous step is still valid. For those at the end it is
// repeated, so that the pattern does not depend on earlier steps: a restarted run has the same matrix.
template <int Dim>
void Barrier<Dim>::begin_step(const StepStart<Dim>& start) {
  if (start.dt == 0) {
    // then the nearest images may be others now
    if (!covers(start.positions) || farthest_from_places(start.positions) > distance()) {
      reaches_.assign(start.positions.size(), near_.least_reach());
      find_near(start.positions);
    }
    const Points<Dim> all = known(start.positions);
    if (!distances().has_started() || start.lagged.dt > 0) near_.follow_distances(all);
    return begin_explicit_friction(all, start);
  }
  constexpr double to_spare = 1.3;
  reaches_.clear();
  for (const auto& velocity : start.velocities)
    reaches_.push_back(std::max(near_.least_reach(), to_spare * start.dt * velocity.norm()));
  find_near(start.positions);
  const Points<Dim> all = known(start.positions);
  places_of_blocks_.lay_out(near_, all);
  near_.follow_distances(all);
  friction_.begin(friction_pairs(all, options_.damping), all, start.dt, start.share);
  seen_.clear();
}

// The friction pairs: what touches now.
template <int Dim>
std::vector<typename PairFriction<Dim>::Pair> Barrier<Dim>::friction_pairs(const Points<Dim>& all,
                                                                           double damping) const {
  std::vector<typename PairFriction<Dim>::Pair> pairs;
  if (options_.friction > 0 || damping > 0)
    for (const Touch<Dim>& touch : near_.at(all))
      if (touch.pressing > 0)
        pairs.push_back({touch.facing, options_.friction * touch.pressing,
                         contact_damping(damping, touch.stiffness, mass_of(touch))});
  return pairs;
}

// Mass of the lighter cloth on the area of the touch [kg].
template <int Dim>
double Barrier<Dim>::mass_of(const Touch<Dim>& touch) const {
  const NearMarkers<Dim>& known = near_.search().known();
  const auto of_cloth = [&](std::size_t marker) {
    return around_.cloths.group_of_piece(known.piece_of(marker)).excess_mass;
  };
  const auto& markers = touch.facing.markers;
  return touch.area * std::min(of_cloth(markers[0]), of_cloth(markers[touch.facing.count - 1]));
}

// Begins an explicit step; with dt = 0 nothing slides.
template <int Dim>
void Barrier<Dim>::begin_explicit_friction(const Points<Dim>& all, const StepStart<Dim>& start) {
  seen_.clear();
  if (start.lagged.dt == 0 || options_.friction == 0) return friction_.begin({}, all, 0);
  friction_.begin_explicit(friction_pairs(all, 0), near_.search().known(), all, known(start.velocities),
                           near_.search().known().values(start.lagged.mobilities), start.lagged.dt);
}

template <int Dim>
void Barrier<Dim>::find_near(const Points<Dim>& positions, Before before) {
  const petsc::LogPart part("contact_search");
  has_looked_ = true;
  places_ = positions;
  near_.find_near(positions, reaches_, before);
  touches_.clear();
  seen_.clear();
}

// Uses the places where touches were evaluated last, or those of a later search.
template <int Dim>
void Barrier<Dim>::renew_pattern() {
  places_of_blocks_.lay_out(near_, known(seen_.size() == places_.size() ? seen_ : places_));
}

template <int Dim>
bool Barrier<Dim>::covers(const Points<Dim>& positions) const {
  bool leaves = !has_looked_;
  for (std::size_t m = 0; m < positions.size() && !leaves; ++m)
    leaves = !((positions[m] - places_[m]).squaredNorm() <= reaches_[m] * reaches_[m]);
  return !any_rank(around_.cloths.comm(), leaves);
}

template <int Dim>
double Barrier<Dim>::farthest_from_places(const Points<Dim>& positions) const {
  double farthest = 0;
  for (std::size_t m = 0; m < positions.size(); ++m) farthest = std::max(farthest, (positions[m] - places_[m]).norm());
  return largest(around_.cloths.comm(), farthest);
}

// Widens the reaches of markers whose motion exceeds them; before the first search, about the motion's start.
template <int Dim>
void Barrier<Dim>::cover(const Points<Dim>& from, const Points<Dim>& motion) {
  const Points<Dim> positions = from + motion;
  if (covers(positions)) return;
  constexpr double to_spare = 1.5;
  if (!has_looked_) {
    places_ = from;
    reaches_.assign(from.size(), near_.least_reach());
  }
  for (std::size_t m = 0; m < positions.size(); ++m)
    reaches_[m] = std::max(reaches_[m], to_spare * (positions[m] - places_[m]).norm());
  const std::vector<std::size_t> before = near_.search().known().numbers();
  find_near(Points<Dim>(places_), Before::keep);
  friction_.renumber([&](std::size_t marker) { return near_.search().known().place_of(before[marker]); });
}

template <int Dim>
const std::vector<Touch<Dim>>& Barrier<Dim>::touches(const Points<Dim>& positions) const {
  if (!any_rank(around_.cloths.comm(), seen_ != positions)) return touches_;
  const Points<Dim> all = known(positions);
  touches_ = near_.at(all);
  friction_.look_at(all);
  seen_ = positions;
  return touches_;
}

// Calls visit(index in `facing`, index among this rank's markers).
template <int Dim>
template <class Visit>
void Barrier<Dim>::visit_own(const Facing<Dim>& facing, const Visit& visit) const {
  const NearMarkers<Dim>& known = near_.search().known();
  for (std::size_t i = 0; i < facing.count; ++i)
    if (known.owns(facing.markers[i])) visit(i, facing.markers[i] - known.begin());
}

template <int Dim>
void Barrier<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  for (const Touch<Dim>& touch : touches(positions))
    visit_own(touch.facing, [&](std::size_t i, std::size_t m) { forces[m] += touch.forces[i]; });
  friction_.visit([&](const auto& facing, const auto& friction) {
    visit_own(facing, [&](std::size_t i, std::size_t m) { forces[m] -= facing.shares[i] * friction.pull; });
  });
}

// Energies are counted by the rank of the first marker.
template <int Dim>
void Barrier<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  const NearMarkers<Dim>& known = near_.search().known();
  const auto add = [&](std::size_t first, double energy) {
    if (known.owns(first)) of_groups[around_.cloths.group_number(first - known.begin())] += energy;
  };
  for (const Touch<Dim>& touch : touches(positions)) add(touch.facing.markers[0], touch.energy);
  friction_.visit([&](const auto& facing, const auto& friction) { add(facing.markers[0], friction.energy); });
}

template <int Dim>
void Barrier<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                   Points<Dim>& rates) const {
  const Points<Dim> all = known(direction);
  const auto add = [&](const Facing<Dim>& facing, const auto& stiffness) {
    Point<Dim> way = Point<Dim>::Zero();
    for (std::size_t i = 0; i < facing.count; ++i) way += facing.shares[i] * all[facing.markers[i]];
    const Point<Dim> rate = stiffness * way;
    visit_own(facing, [&](std::size_t i, std::size_t m) { rates[m] -= facing.shares[i] * rate; });
  };
  for (const Touch<Dim>& touch : touches(positions)) add(touch.facing, touch.block());
  friction_.visit([&](const auto& facing, const auto& friction) { add(facing, friction.stiffness); });
}

template <int Dim>
void Barrier<Dim>::linearise(const Points<Dim>& positions) {
  if (options_.friction == 0) return;
  touches(positions);
  friction_.linearise(known(positions));
}

template <int Dim>
void Barrier<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                                   const AddMarkerBlock<Dim>& add) const {
  std::vector<StiffnessBlock<Dim>> blocks = places_of_blocks_.zeros();
  const auto add_along = [&](const Facing<Dim>& facing, const StiffnessBlock<Dim>& block) {
    const auto of_two = [&](std::size_t i, std::size_t j) -> StiffnessBlock<Dim> {
      return facing.shares[i] * facing.shares[j] * block;
    };
    places_of_blocks_.add(facing, near_.search().known(), of_two, blocks);
  };
  for (const Touch<Dim>& touch : touches(positions)) add_along(touch.facing, touch.block());
  friction_.visit([&](const auto& facing, const auto& friction) { add_along(facing, friction.stiffness); });
  if (geometric == GeometricStiffness::all) add_curvatures(known(positions), blocks);
  places_of_blocks_.visit(blocks, add);
}

template <int Dim>
void Barrier<Dim>::add_curvatures(const Points<Dim>& all, std::vector<StiffnessBlock<Dim>>& blocks) const {
  for (const Touch<Dim>& touch : touches_) {
    const DistanceCurvature<Dim> curvature(touch.facing, all, touch.is_guard);
    if (!curvature.is_regular()) continue;
    const StiffnessBlock<Dim> along = touch.taken_off * touch.facing.normal * touch.facing.normal.transpose();
    const auto block = [&](std::size_t i, std::size_t j) -> StiffnessBlock<Dim> {
      return touch.facing.shares[i] * touch.facing.shares[j] * along - touch.push * curvature.block(i, j);
    };
    places_of_blocks_.add(touch.facing, near_.search().known(), block, blocks);
  }
}

template <int Dim>
void Barrier<Dim>::add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const {
  for (const Touch<Dim>& touch : touches(positions))
    visit_own(touch.facing, [&](std::size_t i, std::size_t m) {
      sizes[m] += touch.stiffness * std::abs(touch.facing.shares[i]) * positions[m].norm();
    });
}

// From the row sums of the last touches, and at least that of two surfaces at a third of d^, which may touch next.
template <int Dim>
void Barrier<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  const double least = 2 * options_.stiffness / distance() * barrier(1.0 / 3).second;
  std::vector<double> sums(bounds.size(), 0.0);
  for (const Touch<Dim>& touch : touches_) {
    double all = 0;
    for (const double share : touch.facing.shares) all += std::abs(share);
    visit_own(touch.facing, [&](std::size_t i, std::size_t m) {
      sums[m] += touch.stiffness * std::abs(touch.facing.shares[i]) * all / around_.cloths.marker_areas()[m];
    });
  }
  for (std::size_t m = 0; m < bounds.size(); ++m) bounds[m].stiffness += 0.25 * std::max(least, sums[m]);
}

// Limits motions to some spacings at a time, so that few pairs come near, and by continuous collision detection.
template <int Dim>
double Barrier<Dim>::step_limit(const Points<Dim>& from, const Points<Dim>& motion) {
  double farthest = 0;
  for (const auto& way : motion) farthest = std::max(farthest, way.norm());
  farthest = largest(around_.cloths.comm(), farthest);
  const double most = most_ways * spacing_;
  double part = farthest > most * (1 + 1e-12) ? most / farthest : 1;
  const Points<Dim> scaled = part * motion;
  cover(from, scaled);
  const Points<Dim> starts = known(from), motions = known(scaled);
  double free = 1;
  for (const auto& pair : near_.pairs())
    free = std::min(free, washfsi::step_limit<Dim>(pair.kind, pair.at(starts), pair.motions(motions)));
  part *= free;
  return -largest(around_.cloths.comm(), -part);
}

// Shortens round by round the motions of pairs that would come too near. This terminates, at the latest with no motion.
template <int Dim>
void Barrier<Dim>::shorten(const Points<Dim>& from, Points<Dim>& motion) {
  constexpr int most_rounds = 100;
  constexpr double shorter = 0.9;
  for (auto& way : motion) way *= std::min(1.0, most_ways * spacing_ / std::max(way.norm(), 1e-300));
  cover(from, motion);
  const Points<Dim> starts = known(from);
  for (int n = 0;; ++n) {
    const Points<Dim> motions = known(motion);
    std::vector<double> parts(motions.size(), 1.0);
    for (const auto& pair : near_.pairs()) {
      const double free = washfsi::step_limit<Dim>(pair.kind, pair.at(starts), pair.motions(motions));
      if (free == 1) continue;
      for (const std::size_t m : pair.markers) parts[m] = std::min(parts[m], n < most_rounds ? shorter * free : 0);
    }
    parts = near_.search().known().least(parts);
    const bool shortens = std::any_of(parts.begin(), parts.end(), [](double part) { return part != 1; });
    if (!any_rank(around_.cloths.comm(), shortens)) return;
    for (std::size_t m = 0; m < motion.size(); ++m) motion[m] *= parts[m];
  }
}

template <int Dim>
void Barrier<Dim>::add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const {
  for (const Touch<Dim>& touch : touches(positions))
    visit_own(touch.facing, [&](std::size_t i, std::size_t m) {
      contact.normal_force[m] += touch.pressing * std::abs(touch.facing.shares[i]);
      contact.area[m] += touch.area * std::abs(touch.facing.shares[i]);
    });
  friction_.visit([&](const auto& facing, const auto& friction) {
    visit_own(facing, [&](std::size_t i, std::size_t m) {
      contact.friction_power[m] += 0.5 * std::abs(facing.shares[i]) * friction.work / friction_.dt();
    });
  });
}

template <int Dim>
TightestContact Barrier<Dim>::tightest() const {
  TightestContact tightest;
  for (const Touch<Dim>& touch : touches_) {
    const double share = touch.facing.distance / near_.begins(touch);
    if (share >= tightest.share) continue;
    const auto name = [&](std::size_t marker) {
      return around_.cloths.name_of(near_.search().known().piece_of(marker));
    };
    const std::string first = name(touch.facing.markers[0]),
                      second = name(touch.facing.markers[touch.facing.count - 1]);
    tightest = {share, first + " and " + (first == second ? "another part of it" : second) + " are " +
                           format_text("%.3g m apart", touch.facing.distance) + " at (" +
                           list_text<Dim>(near_.search().place(touch.facing.markers[0])) + ") m"};
  }
  return tightest;
}

template class Barrier<2>;
template class Barrier<3>;

}  // namespace washfsi
