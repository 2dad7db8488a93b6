// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/pair_friction.hpp"

#include <cmath>

namespace washfsi {

template <int Dim>
void PairFriction<Dim>::begin(std::vector<Pair> pairs, const Points<Dim>& starts, double dt, double share) {
  pairs_ = std::move(pairs);
  std::vector<FrictionPair<Dim>> of_friction;
  for (Pair& pair : pairs_) {
    of_friction.push_back({pair.facing.normal, pair.limit, pair.stops, pair.damping});
    for (std::size_t i = 0; i < pair.facing.count; ++i) pair.starts[i] = starts[pair.facing.markers[i]];
  }
  friction_.begin(std::move(of_friction), dt, share);
  forces_.clear();
}

template <int Dim>
void PairFriction<Dim>::begin_explicit(std::vector<Pair> pairs, const NearMarkers<Dim>& known, const Points<Dim>& all,
                                       const Points<Dim>& velocities, const std::vector<double>& mobilities,
                                       double dt) {
  set_stops(pairs, known, mobilities, dt);
  begin(std::move(pairs), all + -dt * velocities, dt);
}

// Sets `stops` = 2 dt^2 sum |share| D_k F_C,k over the markers k of a pair, with F_C,k = sum |share| mu_C F_n over all
// pairs of marker k, as if all acted in one direction. The owner of a marker has all of its pairs.
template <int Dim>
void PairFriction<Dim>::set_stops(std::vector<Pair>& pairs, const NearMarkers<Dim>& known,
                                  const std::vector<double>& mobilities, double dt) {
  std::vector<double> limits(known.size(), 0.0);
  const auto over_markers = [](const Pair& pair, const auto& visit) {
    for (std::size_t i = 0; i < pair.facing.count; ++i) visit(pair.facing.markers[i], std::abs(pair.facing.shares[i]));
  };
  for (const Pair& pair : pairs)
    over_markers(pair, [&](std::size_t marker, double share) { limits[marker] += share * pair.limit; });
  limits = known.values(known.own(limits));
  for (Pair& pair : pairs) {
    double speed = 0;  // of the slide, per dt
    over_markers(pair, [&](std::size_t marker, double share) { speed += share * mobilities[marker] * limits[marker]; });
    pair.stops = 2 * dt * dt * speed;
  }
}

template <int Dim>
void PairFriction<Dim>::linearise(const Points<Dim>& all) {
  friction_.linearise(ways(all));
  look_at(all);
}

// The ways of the first part of each pair over its second.
template <int Dim>
Points<Dim> PairFriction<Dim>::ways(const Points<Dim>& all) const {
  Points<Dim> ways(pairs_.size(), Point<Dim>::Zero());
  for (std::size_t r = 0; r < ways.size(); ++r)
    for (std::size_t i = 0; i < pairs_[r].facing.count; ++i) {
      const std::size_t marker = pairs_[r].facing.markers[i];
      ways[r] += pairs_[r].facing.shares[i] * (all[marker] - pairs_[r].starts[i]);
    }
  return ways;
}

template class PairFriction<2>;
template class PairFriction<3>;

}  // namespace washfsi
