// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/cloth/facets.hpp"
#include "washfsi/contact/barrier_curvature.hpp"
#include "washfsi/contact/barrier_function.hpp"
#include "washfsi/contact/collision.hpp"
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
    : ContactPotential<Dim>(barrier_distance(options, surroundings.cloths), options.friction, true),
      options_(options),
      cloths_(surroundings.cloths),
      spacing_(least_spacing(surroundings.cloths)),
      contacts_(options, ContactPotential<Dim>::distances(), surroundings),
      places_of_blocks_(surroundings.cloths) {
  places_of_blocks_.lay_out(contacts_.near(), {});
}

// The pattern is that of the step's end.
template <int Dim>
void Barrier<Dim>::begin_step(const StepStart<Dim>& start) {
  const Points<Dim> all = contacts_.begin_step(start);
  if (start.dt != 0) places_of_blocks_.lay_out(contacts_.near(), all);
}

template <int Dim>
void Barrier<Dim>::renew_pattern() {
  places_of_blocks_.lay_out(contacts_.near(), contacts_.values(contacts_.last_places()));
}

template <int Dim>
void Barrier<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  for (const Touch<Dim>& touch : contacts_.at(positions))
    contacts_.visit_own(touch.facing, [&](std::size_t i, std::size_t m) { forces[m] += touch.forces[i]; });
  contacts_.friction().visit([&](const auto& facing, const auto& friction) {
    contacts_.visit_own(facing, [&](std::size_t i, std::size_t m) { forces[m] -= facing.shares[i] * friction.pull; });
  });
}

// Energies are counted by the rank of the first marker.
template <int Dim>
void Barrier<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  const NearMarkers<Dim>& known = contacts_.known();
  const auto add = [&](std::size_t first, double energy) {
    if (known.owns(first)) of_groups[cloths_.group_number(first - known.begin())] += energy;
  };
  for (const Touch<Dim>& touch : contacts_.at(positions)) add(touch.facing.markers[0], touch.energy);
  contacts_.friction().visit(
      [&](const auto& facing, const auto& friction) { add(facing.markers[0], friction.energy); });
}

template <int Dim>
void Barrier<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                   Points<Dim>& rates) const {
  const Points<Dim> all = contacts_.values(direction);
  const auto add = [&](const Facing<Dim>& facing, const auto& stiffness) {
    Point<Dim> way = Point<Dim>::Zero();
    for (std::size_t i = 0; i < facing.count; ++i) way += facing.shares[i] * all[facing.markers[i]];
    const Point<Dim> rate = stiffness * way;
    contacts_.visit_own(facing, [&](std::size_t i, std::size_t m) { rates[m] -= facing.shares[i] * rate; });
  };
  for (const Touch<Dim>& touch : contacts_.at(positions)) add(touch.facing, touch.block());
  contacts_.friction().visit([&](const auto& facing, const auto& friction) { add(facing, friction.stiffness); });
}

template <int Dim>
void Barrier<Dim>::linearise(const Points<Dim>& positions) {
  if (options_.friction > 0) contacts_.linearise(positions);
}

template <int Dim>
void Barrier<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                                   const AddMarkerBlock<Dim>& add) const {
  std::vector<StiffnessBlock<Dim>> blocks = places_of_blocks_.zeros();
  const auto add_along = [&](const Facing<Dim>& facing, const StiffnessBlock<Dim>& block) {
    const auto of_two = [&](std::size_t i, std::size_t j) -> StiffnessBlock<Dim> {
      return facing.shares[i] * facing.shares[j] * block;
    };
    places_of_blocks_.add(facing, contacts_.known(), of_two, blocks);
  };
  for (const Touch<Dim>& touch : contacts_.at(positions)) add_along(touch.facing, touch.block());
  contacts_.friction().visit([&](const auto& facing, const auto& friction) { add_along(facing, friction.stiffness); });
  if (geometric == GeometricStiffness::all)
    add_curvatures(contacts_.last(), contacts_.values(positions), contacts_.known(), places_of_blocks_, blocks);
  places_of_blocks_.visit(blocks, add);
}

template <int Dim>
void Barrier<Dim>::add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const {
  for (const Touch<Dim>& touch : contacts_.at(positions))
    contacts_.visit_own(touch.facing, [&](std::size_t i, std::size_t m) {
      sizes[m] += touch.stiffness * std::abs(touch.facing.shares[i]) * positions[m].norm();
    });
}

// From the row sums of the last touches, and at least that of two surfaces at a third of d^, which may touch next.
template <int Dim>
void Barrier<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  const double least = 2 * options_.stiffness / this->distances().usual() * barrier(1.0 / 3).second;
  std::vector<double> sums(bounds.size(), 0.0);
  for (const Touch<Dim>& touch : contacts_.last()) {
    double all = 0;
    for (const double share : touch.facing.shares) all += std::abs(share);
    contacts_.visit_own(touch.facing, [&](std::size_t i, std::size_t m) {
      sums[m] += touch.stiffness * std::abs(touch.facing.shares[i]) * all / cloths_.marker_areas()[m];
    });
  }
  for (std::size_t m = 0; m < bounds.size(); ++m) bounds[m].stiffness += 0.25 * std::max(least, sums[m]);
}

// Limits motions to some spacings at a time, so that few pairs come near, and by continuous collision detection.
template <int Dim>
double Barrier<Dim>::step_limit(const Points<Dim>& from, const Points<Dim>& motion) {
  double farthest = 0;
  for (const auto& way : motion) farthest = std::max(farthest, way.norm());
  farthest = largest(cloths_.comm(), farthest);
  const double most = most_ways * spacing_;
  double part = farthest > most * (1 + 1e-12) ? most / farthest : 1;
  const Points<Dim> scaled = part * motion;
  contacts_.cover(from, scaled);
  const Points<Dim> starts = contacts_.values(from), motions = contacts_.values(scaled);
  double free = 1;
  for (const auto& pair : contacts_.near().pairs())
    free = std::min(free, washfsi::step_limit<Dim>(pair.kind, pair.at(starts), pair.motions(motions)));
  part *= free;
  return -largest(cloths_.comm(), -part);
}

// Shortens round by round the motions of pairs that would come too near. This terminates, at the latest with no motion.
template <int Dim>
void Barrier<Dim>::shorten(const Points<Dim>& from, Points<Dim>& motion) {
  constexpr int most_rounds = 100;
  constexpr double shorter = 0.9;
  for (auto& way : motion) way *= std::min(1.0, most_ways * spacing_ / std::max(way.norm(), 1e-300));
  contacts_.cover(from, motion);
  const Points<Dim> starts = contacts_.values(from);
  for (int n = 0;; ++n) {
    const Points<Dim> motions = contacts_.values(motion);
    std::vector<double> parts(motions.size(), 1.0);
    for (const auto& pair : contacts_.near().pairs()) {
      const double free = washfsi::step_limit<Dim>(pair.kind, pair.at(starts), pair.motions(motions));
      if (free == 1) continue;
      for (const std::size_t m : pair.markers) parts[m] = std::min(parts[m], n < most_rounds ? shorter * free : 0);
    }
    parts = contacts_.known().least(parts);
    const bool shortens = std::any_of(parts.begin(), parts.end(), [](double part) { return part != 1; });
    if (!any_rank(cloths_.comm(), shortens)) return;
    for (std::size_t m = 0; m < motion.size(); ++m) motion[m] *= parts[m];
  }
}

template <int Dim>
void Barrier<Dim>::add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const {
  for (const Touch<Dim>& touch : contacts_.at(positions))
    contacts_.visit_own(touch.facing, [&](std::size_t i, std::size_t m) {
      contact.normal_force[m] += touch.pressing * std::abs(touch.facing.shares[i]);
      contact.area[m] += touch.area * std::abs(touch.facing.shares[i]);
    });
  contacts_.friction().visit([&](const auto& facing, const auto& friction) {
    contacts_.visit_own(facing, [&](std::size_t i, std::size_t m) {
      contact.friction_power[m] += 0.5 * std::abs(facing.shares[i]) * friction.work / contacts_.friction().dt();
    });
  });
}

template <int Dim>
TightestContact Barrier<Dim>::tightest() const {
  TightestContact tightest;
  for (const Touch<Dim>& touch : contacts_.last()) {
    const double share = touch.facing.distance / contacts_.near().begins(touch);
    if (share >= tightest.share) continue;
    const auto name = [&](std::size_t marker) { return cloths_.name_of(contacts_.known().piece_of(marker)); };
    const std::string first = name(touch.facing.markers[0]),
                      second = name(touch.facing.markers[touch.facing.count - 1]);
    tightest = {share, first + " and " + (first == second ? "another part of it" : second) + " are " +
                           format_text("%.3g m apart", touch.facing.distance) + " at (" +
                           list_text<Dim>(contacts_.near().search().place(touch.facing.markers[0])) + ") m"};
  }
  return tightest;
}

template class Barrier<2>;
template class Barrier<3>;

}  // namespace washfsi
