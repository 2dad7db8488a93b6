// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/even_spread.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

namespace {

// `reach` is the largest distance of a search [m].
template <int Dim>
NearSearch<Dim> search_among(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& reach) {
  Points<Dim> places;
  for (const auto& candidate : candidates) places.push_back(candidate.place);
  const std::vector<Bounds<Dim>> bounds = bounds_of(places);
  return NearSearch<Dim>(bounds, reach, hull(bounds));
}

/// Removes the most crowded of some places, one after the other (`spread_evenly`).
template <int Dim>
class Elimination {
 public:
  Elimination(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing)
      : candidates_(candidates), scale_(spacing.cwiseInverse()), near_(candidates.size()) {
    const NearSearch<Dim> search = search_among(candidates, spacing);
    // each tells the others of itself, so that their sums are in its order and not in that of the bins
    for (std::size_t m = 0; m < candidates_.size(); ++m)
      search.visit_near(Bounds<Dim>::round(candidates_[m].place, influence * spacing), [&](std::size_t other) {
        if (other != m && apart(m, other) < influence) near_[other].push_back(static_cast<Number>(m));
      });
  }

  // Removes places until all are a spacing from each other; restores those that have room again.
  std::vector<Candidate<Dim>> thinned() {
    const std::vector<std::size_t> order = take_away([&](std::size_t place) { return too_near_[place] > 0; });
    fill_gaps(order);
    return left();
  }

  std::vector<Candidate<Dim>> reduced_to(std::size_t count) {
    std::size_t many = candidates_.size();
    (void)take_away([&](std::size_t) { return many > count && many-- > 0; });
    return left();
  }

 private:
  static constexpr double influence = 2;  // farther than this many spacings places do not crowd each other
  using Number = std::uint32_t;           // of which there are hundreds for each place

  // Removes the most crowded remaining place, one after the other, where `goes(place)`; returns them in that order.
  template <class Goes>
  std::vector<std::size_t> take_away(Goes&& goes) {
    crowding_.assign(candidates_.size(), 0.0);
    too_near_.assign(candidates_.size(), 0);
    gone_.assign(candidates_.size(), 0);
    std::priority_queue<std::pair<double, std::size_t>> queue;  // by how crowded each was once: never less than now
    for (std::size_t m = 0; m < candidates_.size(); ++m) {
      for (const Number other : near_[m]) add(m, other, 1);
      queue.emplace(crowding_[m], m);
    }
    std::vector<std::size_t> order;
    while (!queue.empty()) {
      const auto [crowding, worst] = queue.top();
      queue.pop();
      if (crowding != crowding_[worst]) {
        queue.emplace(crowding_[worst], worst);
        continue;
      }
      if (!goes(worst)) continue;
      gone_[worst] = 1;
      order.push_back(worst);
      for (const Number other : near_[worst])
        if (!gone_[other]) add(other, worst, -1);
    }
    return order;
  }

  // Restores, the last first, places to which no other is too near any more.
  void fill_gaps(std::vector<std::size_t> order) {
    std::ranges::reverse(order);
    for (const std::size_t place : order)
      if (std::ranges::none_of(near_[place], [&](Number other) { return !gone_[other] && apart(place, other) < 1; }))
        gone_[place] = 0;
  }

  std::vector<Candidate<Dim>> left() const {
    std::vector<Candidate<Dim>> left;
    for (std::size_t m = 0; m < candidates_.size(); ++m)
      if (!gone_[m]) left.push_back(candidates_[m]);
    return left;
  }

  double apart(std::size_t a, std::size_t b) const {
    return (candidates_[a].place - candidates_[b].place).cwiseProduct(scale_).norm();
  }

  // Edges crowd less, so that they are kept.
  void add(std::size_t m, std::size_t other, int sign) {
    const double distance = apart(m, other);
    const double nearness = 1 - distance / influence;
    const double kept = 1 + 20 * candidates_[m].sharpness;
    crowding_[m] += sign * nearness * nearness * nearness * nearness / kept;
    if (distance < 1) too_near_[m] += sign;
  }

  const std::vector<Candidate<Dim>>& candidates_;
  Point<Dim> scale_;
  std::vector<std::vector<Number>> near_;  ///< neighbours of each place, in ascending order
  std::vector<double> crowding_;
  std::vector<int> too_near_;
  std::vector<char> gone_;
};

// The middle nearest to a place within some spacings, among equals the first, and how far off it is; without one, the
// number of middles.
template <int Dim>
std::pair<std::size_t, double> nearest_within(double reach, const NearSearch<Dim>& search, const Point<Dim>& place,
                                              const std::vector<Candidate<Dim>>& middles, const Point<Dim>& spacing) {
  std::pair<std::size_t, double> best{middles.size(), std::numeric_limits<double>::max()};
  search.visit_near(Bounds<Dim>::round(place, reach * spacing), [&](std::size_t m) {
    const double apart = (middles[m].place - place).cwiseQuotient(spacing).norm();
    if (apart < best.second || (apart == best.second && m < best.first)) best = {m, apart};
  });
  return best;
}

// The nearest middle of each candidate; the number of middles where none is within two spacings.
template <int Dim>
std::vector<std::size_t> nearest(const std::vector<Candidate<Dim>>& candidates,
                                 const std::vector<Candidate<Dim>>& middles, const Point<Dim>& spacing) {
  const NearSearch<Dim> search = search_among(middles, spacing);
  std::vector<std::size_t> result;
  for (const auto& candidate : candidates) {
    auto [middle, apart] = nearest_within<Dim>(1, search, candidate.place, middles, spacing);
    if (apart > 1) middle = nearest_within<Dim>(2, search, candidate.place, middles, spacing).first;
    result.push_back(middle);
  }
  return result;
}

// Lloyd's method, with the candidate nearest to the middle in place of the middle.
template <int Dim>
std::vector<Candidate<Dim>> relaxed(std::vector<Candidate<Dim>> chosen, const std::vector<Candidate<Dim>>& candidates,
                                    const Point<Dim>& spacing) {
  constexpr int sweeps = 20;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const std::vector<std::size_t> owners = nearest(candidates, chosen, spacing);
    const auto may_take = [&](std::size_t n) {
      return owners[n] < chosen.size() && candidates[n].sharpness == chosen[owners[n]].sharpness;
    };
    Points<Dim> middles(chosen.size(), Point<Dim>::Zero());
    std::vector<double> counts(chosen.size(), 0.0), least(chosen.size(), std::numeric_limits<double>::max());
    for (std::size_t n = 0; n < candidates.size(); ++n)
      if (may_take(n)) {
        middles[owners[n]] += candidates[n].place;
        ++counts[owners[n]];
      }
    std::vector<Candidate<Dim>> next = chosen;
    for (std::size_t n = 0; n < candidates.size(); ++n) {
      if (!may_take(n)) continue;
      const std::size_t m = owners[n];
      const double apart = (candidates[n].place - middles[m] / counts[m]).cwiseQuotient(spacing).norm();
      if (apart >= least[m]) continue;
      least[m] = apart;
      next[m] = candidates[n];
    }
    const bool rests = std::equal(next.begin(), next.end(), chosen.begin(),
                                  [](const auto& a, const auto& b) { return a.place == b.place; });
    if (rests) break;
    chosen = std::move(next);
  }
  return chosen;
}

// The cell of each marker, after Lloyd's method with the cells' middles.
template <int Dim>
std::vector<std::size_t> equal_cells(const std::vector<Candidate<Dim>>& markers, std::vector<Candidate<Dim>> middles,
                                     const Point<Dim>& spacing) {
  constexpr int sweeps = 40;
  std::vector<std::size_t> owners = nearest(markers, middles, spacing);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    Points<Dim> sums(middles.size() + 1, Point<Dim>::Zero());  // the last sum is of those that are near to none
    std::vector<double> counts(middles.size() + 1, 0.0);
    for (std::size_t m = 0; m < markers.size(); ++m) {
      sums[owners[m]] += markers[m].place;
      ++counts[owners[m]];
    }
    for (std::size_t c = 0; c < middles.size(); ++c)
      if (counts[c] > 0) middles[c].place = sums[c] / counts[c];
    std::vector<std::size_t> next = nearest(markers, middles, spacing);
    if (next == owners) break;
    owners = std::move(next);
  }
  return owners;
}

template <int Dim>
using Cells = std::vector<std::vector<Candidate<Dim>>>;

template <int Dim>
Cells<Dim> in_cells(const std::vector<Candidate<Dim>>& markers, std::size_t count, const Point<Dim>& spacing) {
  const std::vector<std::size_t> owners =
      equal_cells(markers, Elimination<Dim>(markers, spacing).reduced_to(count), spacing);
  Cells<Dim> cells(count);
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (owners[m] < count) cells[owners[m]].push_back(markers[m]);
  return cells;
}

// Returns the place nearest to the middle of all.
template <int Dim>
Candidate<Dim> middlemost(const std::vector<Candidate<Dim>>& markers, const Point<Dim>& spacing) {
  Point<Dim> sum = Point<Dim>::Zero();
  for (const auto& marker : markers) sum += marker.place;
  const Point<Dim> middle = sum / static_cast<double>(markers.size());
  return *std::ranges::min_element(
      markers, {}, [&](const auto& marker) { return (marker.place - middle).cwiseQuotient(spacing).norm(); });
}

template <int Dim>
std::vector<Candidate<Dim>> thinned_to(std::size_t count, const std::vector<Candidate<Dim>>& markers,
                                       const Point<Dim>& spacing) {
  std::vector<Candidate<Dim>> result;
  for (const auto& cell : in_cells<Dim>(markers, count, spacing))
    if (!cell.empty()) result.push_back(middlemost<Dim>(cell, spacing));
  return result;
}

}  // namespace

template <int Dim>
std::vector<Candidate<Dim>> thinned(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing) {
  return Elimination<Dim>(candidates, spacing).thinned();
}

template <int Dim>
std::vector<Candidate<Dim>> spread_evenly(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing) {
  return relaxed<Dim>(thinned<Dim>(candidates, spacing), candidates, spacing);
}

template <int Dim>
MarkerPatches<Dim> gathered(std::vector<Candidate<Dim>> markers, std::size_t count, const Point<Dim>& spacing,
                            std::size_t most) {
  for (auto& marker : markers) marker.sharpness = 0;
  MarkerPatches<Dim> patches;
  for (const auto& cell : in_cells<Dim>(markers, count, spacing)) {
    for (const auto& marker : cell.size() > most ? thinned_to<Dim>(most, cell, spacing) : cell) {
      patches.markers.push_back(marker.place);
      patches.feet.push_back(marker.foot);
    }
    if (!cell.empty()) patches.starts.push_back(patches.markers.size());
  }
  return patches;
}

template std::vector<Candidate<2>> thinned<2>(const std::vector<Candidate<2>>&, const Point<2>&);
template std::vector<Candidate<2>> spread_evenly<2>(const std::vector<Candidate<2>>&, const Point<2>&);
template MarkerPatches<2> gathered<2>(std::vector<Candidate<2>>, std::size_t, const Point<2>&, std::size_t);
template std::vector<Candidate<3>> thinned<3>(const std::vector<Candidate<3>>&, const Point<3>&);
template std::vector<Candidate<3>> spread_evenly<3>(const std::vector<Candidate<3>>&, const Point<3>&);
template MarkerPatches<3> gathered<3>(std::vector<Candidate<3>>, std::size_t, const Point<3>&, std::size_t);

}  // namespace washfsi
