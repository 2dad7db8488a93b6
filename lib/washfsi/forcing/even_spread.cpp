// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/even_spread.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <queue>

#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

namespace {

// `reach`: of what is asked for [m].
template <int Dim>
NearSearch<Dim> search_among(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& reach) {
  Points<Dim> places;
  for (const auto& candidate : candidates) places.push_back(candidate.place);
  const std::vector<Bounds<Dim>> bounds = bounds_of(places);
  return NearSearch<Dim>(bounds, reach, hull(bounds));
}

/// The first half of `spread_evenly`.
template <int Dim>
class Elimination {
 public:
  Elimination(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing)
      : candidates_(candidates), scale_(spacing.cwiseInverse()) {
    const NearSearch<Dim> search = search_among(candidates, spacing);
    for (std::size_t m = 0; m < candidates_.size(); ++m) {
      pairs_.emplace_back();
      for (const std::size_t other : search.near(Bounds<Dim>::round(candidates_[m].place, influence * spacing)))
        if (const double distance = apart(m, other); other != m && distance < influence)
          pairs_.back().push_back({other, distance});
    }
  }

  std::vector<Candidate<Dim>> run() {
    crowding_.assign(candidates_.size(), 0.0);
    too_near_.assign(candidates_.size(), 0);
    std::priority_queue<std::pair<double, std::size_t>> queue;  // with entries that are out of date
    for (std::size_t m = 0; m < candidates_.size(); ++m) {
      for (const Pair& pair : pairs_[m]) add(m, pair, 1);
      if (too_near_[m] > 0) queue.emplace(crowding_[m], m);
    }
    std::vector<char> gone(candidates_.size(), 0);
    std::vector<std::size_t> order;  // of those that went
    while (!queue.empty()) {
      const auto [crowding, worst] = queue.top();
      queue.pop();
      if (gone[worst] || crowding != crowding_[worst] || too_near_[worst] == 0) continue;
      gone[worst] = 1;
      order.push_back(worst);
      for (const Pair& pair : pairs_[worst]) {
        if (gone[pair.other]) continue;
        add(pair.other, {worst, pair.distance}, -1);
        if (too_near_[pair.other] > 0) queue.emplace(crowding_[pair.other], pair.other);
      }
    }
    fill_gaps(order, gone);
    std::vector<Candidate<Dim>> left;
    for (std::size_t m = 0; m < candidates_.size(); ++m)
      if (!gone[m]) left.push_back(candidates_[m]);
    return left;
  }

 private:
  static constexpr double influence = 2;  // farther than this many spacings places do not crowd each other
  struct Pair {
    std::size_t other;
    double distance;
  };

  // Takes back, the last first, what no other is too near any more.
  void fill_gaps(const std::vector<std::size_t>& order, std::vector<char>& gone) const {
    for (auto place = order.rbegin(); place != order.rend(); ++place)
      if (std::none_of(pairs_[*place].begin(), pairs_[*place].end(),
                       [&](const Pair& pair) { return pair.distance < 1 && !gone[pair.other]; }))
        gone[*place] = 0;
  }

  double apart(std::size_t a, std::size_t b) const {
    return (candidates_[a].place - candidates_[b].place).cwiseProduct(scale_).norm();
  }

  // Edges crowd less, so that they are kept.
  void add(std::size_t m, const Pair& pair, int sign) {
    const double nearness = 1 - pair.distance / influence;
    const double kept = 1 + 20 * candidates_[m].sharpness;
    crowding_[m] += sign * nearness * nearness * nearness * nearness / kept;
    if (pair.distance < 1) too_near_[m] += sign;
  }

  const std::vector<Candidate<Dim>>& candidates_;
  Point<Dim> scale_;
  std::vector<std::vector<Pair>> pairs_;
  std::vector<double> crowding_;
  std::vector<int> too_near_;
};

// The nearest middle of each candidate; the number of middles where none is within two spacings.
template <int Dim>
std::vector<std::size_t> nearest(const std::vector<Candidate<Dim>>& candidates,
                                 const std::vector<Candidate<Dim>>& middles, const Point<Dim>& spacing) {
  const NearSearch<Dim> search = search_among(middles, spacing);
  std::vector<std::size_t> result;
  for (const auto& candidate : candidates) {
    result.push_back(middles.size());
    double least = std::numeric_limits<double>::max();
    for (const std::size_t m : search.near(Bounds<Dim>::round(candidate.place, 2 * spacing)))
      if (const double apart = (middles[m].place - candidate.place).cwiseQuotient(spacing).norm(); apart < least) {
        least = apart;
        result.back() = m;
      }
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

}  // namespace

template <int Dim>
std::vector<Candidate<Dim>> spread_evenly(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing) {
  return relaxed<Dim>(Elimination<Dim>(candidates, spacing).run(), candidates, spacing);
}

template <int Dim>
MarkerPatches<Dim> gathered(std::vector<Candidate<Dim>> markers, const Point<Dim>& spacing) {
  if (markers.empty()) return {};
  for (auto& marker : markers) marker.sharpness = 0;
  const auto middles = spread_evenly<Dim>(markers, spacing);
  const std::vector<std::size_t> owners = nearest(markers, middles, spacing);
  std::vector<std::vector<std::size_t>> of_middle(middles.size());
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (owners[m] < middles.size()) of_middle[owners[m]].push_back(m);
  MarkerPatches<Dim> patches;
  for (const auto& of_one : of_middle) {
    for (const std::size_t m : of_one) {
      patches.markers.push_back(markers[m].place);
      patches.feet.push_back(markers[m].foot);
    }
    if (!of_one.empty()) patches.starts.push_back(patches.markers.size());
  }
  return patches;
}

template std::vector<Candidate<2>> spread_evenly<2>(const std::vector<Candidate<2>>&, const Point<2>&);
template MarkerPatches<2> gathered<2>(std::vector<Candidate<2>>, const Point<2>&);
template std::vector<Candidate<3>> spread_evenly<3>(const std::vector<Candidate<3>>&, const Point<3>&);
template MarkerPatches<3> gathered<3>(std::vector<Candidate<3>>, const Point<3>&);

}  // namespace washfsi
