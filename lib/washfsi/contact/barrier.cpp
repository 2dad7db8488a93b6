// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/contact/collision.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr double most_ways = 2;  // that markers go at a time, in spacings
constexpr double ahead = 1.25;   // pairs that are nearer than this times d^ have places in the matrix

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
      distance_(barrier_distance(options, surroundings.cloths)),
      spacing_(least_spacing(surroundings.cloths)),
      search_(surroundings.cloths, periods_of<Dim>(surroundings.grid)) {
  lay_out();
}

// For the forces at the start all is known that was looked at for the end of the step before. For those at the end it
// looks round anew, so that what is laid out does not depend on what was before: a restarted run has the same matrix.
template <int Dim>
void Barrier<Dim>::begin_step(const StepStart<Dim>& start) {
  if (start.dt == 0) {
    // then the nearest images may be others now
    if (!covers(start.positions) || farthest_from_places(start.positions) > distance_) {
      reaches_.assign(start.positions.size(), least_reach());
      look_round(start.positions);
    }
    return begin_explicit_friction(known(start.positions), start);
  }
  constexpr double to_spare = 1.3;
  reaches_.clear();
  for (const auto& velocity : start.velocities)
    reaches_.push_back(std::max(least_reach(), to_spare * start.dt * velocity.norm()));
  look_round(start.positions);
  lay_out();
  const Points<Dim> all = known(start.positions);
  friction_.begin(rubbing_pairs(all), all, start.dt, start.share);
  seen_.clear();
}

// What touches now.
template <int Dim>
std::vector<typename PairFriction<Dim>::Pair> Barrier<Dim>::rubbing_pairs(const Points<Dim>& all) const {
  std::vector<typename PairFriction<Dim>::Pair> pairs;
  if (options_.friction > 0)
    for (const Touch& touch : touches_at(all))
      pairs.push_back({*touch.pair, touch.gap, options_.friction * touch.push});
  return pairs;
}

// In no time nothing slides.
template <int Dim>
void Barrier<Dim>::begin_explicit_friction(const Points<Dim>& all, const StepStart<Dim>& start) {
  seen_.clear();
  if (start.held.dt == 0 || options_.friction == 0) return friction_.begin({}, all, 0);
  friction_.begin_explicit(rubbing_pairs(all), search_.known(), all, known(start.velocities),
                           search_.known().values(start.held.mobilities), start.held.dt);
}

template <int Dim>
void Barrier<Dim>::look_round(const Points<Dim>& positions, Before before) {
  const petsc::LogPart part("contact_search");
  has_looked_ = true;
  places_ = positions;
  pairs_ = search_.find(positions, reaches_, distance_, before);
  touches_.clear();
  seen_.clear();
}

// The blocks of pairs that touch, or soon may. Those of others, which come up while the step is solved for, are left
// out but for their diagonal ones: the matrix stays positive.
template <int Dim>
void Barrier<Dim>::lay_out() {
  const std::vector<std::size_t>& numbers = search_.known().numbers();
  std::vector<std::vector<std::size_t>> columns(around_.cloths.owned());
  for (std::size_t m = 0; m < columns.size(); ++m) columns[m].push_back(numbers[search_.known().begin() + m]);
  for (const auto& pair : pairs_) {
    if (pair.start >= ahead * distance_) continue;
    visit_own(pair, [&](std::size_t, std::size_t row) {
      for (const std::size_t marker : pair.markers) columns[row].push_back(numbers[marker]);
    });
  }
  const std::vector<std::size_t> before = std::move(columns_);
  columns_.clear();
  rows_.assign(1, 0);
  for (auto& row : columns) {
    std::sort(row.begin(), row.end());
    columns_.insert(columns_.end(), row.begin(), std::unique(row.begin(), row.end()));
    rows_.push_back(columns_.size());
  }
  if (columns_ != before) ++pattern_;
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

// Widens the reach of the markers that leave it on a way; before it has looked round, about the way's start.
template <int Dim>
void Barrier<Dim>::cover(const Points<Dim>& from, const Points<Dim>& motion) {
  const Points<Dim> positions = from + motion;
  if (covers(positions)) return;
  constexpr double to_spare = 1.5;
  if (!has_looked_) {
    places_ = from;
    reaches_.assign(from.size(), least_reach());
  }
  for (std::size_t m = 0; m < positions.size(); ++m)
    reaches_[m] = std::max(reaches_[m], to_spare * (positions[m] - places_[m]).norm());
  const std::vector<std::size_t> before = search_.known().numbers();
  look_round(Points<Dim>(places_), Before::keep);
  friction_.renumber([&](std::size_t marker) { return search_.known().place_of(before[marker]); });
}

template <int Dim>
typename Barrier<Dim>::Touch Barrier<Dim>::touch(const FacetPair<Dim>& pair, const Gap<Dim>& gap,
                                                 const PairPoints<Dim>& places) const {
  const BarrierValue b = barrier(gap.distance / distance_);
  const double scale = options_.stiffness * pair.weight;
  Touch touch{&pair, gap, scale * distance_ * b.value, scale / distance_ * b.second, -scale * b.first, {}};
  if constexpr (Dim == 3) {
    const Mollifier m = pair.parallel > 0 ? mollifier(places, pair.parallel) : Mollifier{};
    for (std::size_t i = 0; i < places.size(); ++i) touch.forces[i] = -touch.energy * m.gradient[i];
    touch.energy *= m.value;
    touch.stiffness *= m.value;
    touch.push *= m.value;
  } else {
    touch.forces.fill(Point<Dim>::Zero());
  }
  for (std::size_t i = 0; i < places.size(); ++i) touch.forces[i] += touch.push * gap.shares[i] * gap.normal;
  return touch;
}

// Facets that touch, as they do only where the places are not those of a cloth, have no barrier.
template <int Dim>
std::vector<typename Barrier<Dim>::Touch> Barrier<Dim>::touches_at(const Points<Dim>& all) const {
  std::vector<Touch> touches;
  for (const auto& pair : pairs_) {
    const PairPoints<Dim> places = pair.at(all);
    const Gap<Dim> gap = gap_of<Dim>(pair.kind, places);
    if (gap.distance > 0 && gap.distance < distance_) touches.push_back(touch(pair, gap, places));
  }
  return touches;
}

template <int Dim>
const std::vector<typename Barrier<Dim>::Touch>& Barrier<Dim>::touches(const Points<Dim>& positions) const {
  if (!any_rank(around_.cloths.comm(), seen_ != positions)) return touches_;
  const Points<Dim> all = known(positions);
  touches_ = touches_at(all);
  friction_.look_at(all);
  seen_ = positions;
  return touches_;
}

// visit(which of the pair's markers, its number among this rank's)
template <int Dim>
template <class Visit>
void Barrier<Dim>::visit_own(const FacetPair<Dim>& pair, const Visit& visit) const {
  const NearMarkers<Dim>& known = search_.known();
  for (std::size_t i = 0; i < pair.markers.size(); ++i)
    if (known.owns(pair.markers[i])) visit(i, pair.markers[i] - known.begin());
}

template <int Dim>
void Barrier<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  for (const Touch& touch : touches(positions))
    visit_own(*touch.pair, [&](std::size_t i, std::size_t m) { forces[m] += touch.forces[i]; });
  friction_.visit([&](const auto& pair, const auto& gap, const auto& rub) {
    visit_own(pair, [&](std::size_t i, std::size_t m) { forces[m] -= gap.shares[i] * rub.pull; });
  });
}

// Of a pair by the rank of its first marker.
template <int Dim>
void Barrier<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  const NearMarkers<Dim>& known = search_.known();
  const auto add = [&](std::size_t first, double energy) {
    if (known.owns(first)) of_groups[around_.cloths.group_number(first - known.begin())] += energy;
  };
  for (const Touch& touch : touches(positions)) add(touch.pair->markers[0], touch.energy);
  friction_.visit([&](const auto& pair, const auto&, const auto& rub) { add(pair.markers[0], rub.energy); });
}

template <int Dim>
void Barrier<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                   Points<Dim>& rates) const {
  const Points<Dim> all = known(direction);
  const auto add = [&](const FacetPair<Dim>& pair, const Gap<Dim>& gap, const auto& stiffness) {
    Point<Dim> way = Point<Dim>::Zero();
    for (std::size_t i = 0; i < gap.shares.size(); ++i) way += gap.shares[i] * all[pair.markers[i]];
    const Point<Dim> rate = stiffness * way;
    visit_own(pair, [&](std::size_t i, std::size_t m) { rates[m] -= gap.shares[i] * rate; });
  };
  for (const Touch& touch : touches(positions)) add(*touch.pair, touch.gap, touch.block());
  friction_.visit([&](const auto& pair, const auto& gap, const auto& rub) { add(pair, gap, rub.stiffness); });
}

// Into the places that were laid out for them.
template <int Dim>
void Barrier<Dim>::add_blocks(const FacetPair<Dim>& pair, const Gap<Dim>& gap, const StiffnessBlock<Dim>& block,
                              std::vector<StiffnessBlock<Dim>>& blocks) const {
  const std::vector<std::size_t>& numbers = search_.known().numbers();
  visit_own(pair, [&](std::size_t i, std::size_t m) {
    const auto row = columns_.begin() + static_cast<long>(rows_[m]),
               end = columns_.begin() + static_cast<long>(rows_[m + 1]);
    for (std::size_t j = 0; j < pair.markers.size(); ++j) {
      const std::size_t column = numbers[pair.markers[j]];
      const auto place = std::lower_bound(row, end, column);
      if (place != end && *place == column)
        blocks[static_cast<std::size_t>(place - columns_.begin())] += gap.shares[i] * gap.shares[j] * block;
    }
  });
}

template <int Dim>
void Barrier<Dim>::linearise(const Points<Dim>& positions) {
  if (options_.friction == 0) return;
  touches(positions);
  friction_.linearise(known(positions));
}

template <int Dim>
void Barrier<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness,
                                   const AddMarkerBlock<Dim>& add) const {
  std::vector<StiffnessBlock<Dim>> blocks(columns_.size(), StiffnessBlock<Dim>::Zero());
  for (const Touch& touch : touches(positions)) add_blocks(*touch.pair, touch.gap, touch.block(), blocks);
  friction_.visit(
      [&](const auto& pair, const auto& gap, const auto& rub) { add_blocks(pair, gap, rub.stiffness, blocks); });
  for (std::size_t m = 0; m + 1 < rows_.size(); ++m)
    for (std::size_t n = rows_[m]; n < rows_[m + 1]; ++n)
      add(around_.cloths.number_of(m), static_cast<PetscInt>(columns_[n]), blocks[n]);
}

template <int Dim>
void Barrier<Dim>::add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const {
  for (const Touch& touch : touches(positions))
    visit_own(*touch.pair, [&](std::size_t i, std::size_t m) {
      sizes[m] += touch.stiffness * std::abs(touch.gap.shares[i]) * positions[m].norm();
    });
}

// By the rows' sums of what touched last, and at least as for a pair at a third of d^, which may touch next.
template <int Dim>
void Barrier<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  const double least = 2 * options_.stiffness / distance_ * barrier(1.0 / 3).second;
  std::vector<double> sums(bounds.size(), 0.0);
  for (const Touch& touch : touches_) {
    double all = 0;
    for (const double share : touch.gap.shares) all += std::abs(share);
    visit_own(*touch.pair, [&](std::size_t i, std::size_t m) {
      sums[m] += touch.stiffness * std::abs(touch.gap.shares[i]) * all / around_.cloths.marker_areas()[m];
    });
  }
  for (std::size_t m = 0; m < bounds.size(); ++m) bounds[m].stiffness += 0.25 * std::max(least, sums[m]);
}

// No marker goes farther than some spacings at a time, so that what comes near remains little.
template <int Dim>
double Barrier<Dim>::free_part(const Points<Dim>& from, const Points<Dim>& motion) {
  double farthest = 0;
  for (const auto& way : motion) farthest = std::max(farthest, way.norm());
  farthest = largest(around_.cloths.comm(), farthest);
  const double most = most_ways * spacing_;
  double part = farthest > most * (1 + 1e-12) ? most / farthest : 1;
  const Points<Dim> scaled = part * motion;
  cover(from, scaled);
  const Points<Dim> starts = known(from), motions = known(scaled);
  double free = 1;
  for (const auto& pair : pairs_)
    free = std::min(free, washfsi::free_part<Dim>(pair.kind, pair.at(starts), pair.motions(motions)));
  part *= free;
  return -largest(around_.cloths.comm(), -part);
}

// Shortens round by round the motions of pairs that would come too near. That ends, at the latest with no motion at
// all.
template <int Dim>
void Barrier<Dim>::hold_back(const Points<Dim>& from, Points<Dim>& motion) {
  constexpr int most_rounds = 100;
  constexpr double shorter = 0.9;
  for (auto& way : motion) way *= std::min(1.0, most_ways * spacing_ / std::max(way.norm(), 1e-300));
  cover(from, motion);
  const Points<Dim> starts = known(from);
  for (int n = 0;; ++n) {
    const Points<Dim> motions = known(motion);
    std::vector<double> parts(motions.size(), 1.0);
    for (const auto& pair : pairs_) {
      const double free = washfsi::free_part<Dim>(pair.kind, pair.at(starts), pair.motions(motions));
      if (free == 1) continue;
      for (const std::size_t m : pair.markers) parts[m] = std::min(parts[m], n < most_rounds ? shorter * free : 0);
    }
    parts = search_.known().least(parts);
    const bool shortens = std::any_of(parts.begin(), parts.end(), [](double part) { return part != 1; });
    if (!any_rank(around_.cloths.comm(), shortens)) return;
    for (std::size_t m = 0; m < motion.size(); ++m) motion[m] *= parts[m];
  }
}

template <int Dim>
void Barrier<Dim>::add_marker_contact(const Points<Dim>& positions, MarkerContact& contact) const {
  for (const Touch& touch : touches(positions))
    visit_own(*touch.pair, [&](std::size_t i, std::size_t m) {
      contact.normal_force[m] += touch.push * std::abs(touch.gap.shares[i]);
      contact.area[m] += touch.pair->weight * std::abs(touch.gap.shares[i]);
    });
  friction_.visit([&](const auto& pair, const auto& gap, const auto& rub) {
    visit_own(pair, [&](std::size_t i, std::size_t m) {
      contact.friction_power[m] += 0.5 * std::abs(gap.shares[i]) * rub.work / friction_.dt();
    });
  });
}

template class Barrier<2>;
template class Barrier<3>;

}  // namespace washfsi
