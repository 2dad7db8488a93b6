// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/pair_friction.hpp"

namespace washfsi {

template <int Dim>
void PairFriction<Dim>::begin(std::vector<Pair> pairs, const Points<Dim>& all, double dt) {
  pairs_ = std::move(pairs);
  starts_ = all;
  std::vector<Rub<Dim>> rubs;
  for (const Pair& pair : pairs_) rubs.push_back({pair.gap.normal, pair.limit});
  friction_.begin(std::move(rubs), dt);
  forces_.clear();
}

template <int Dim>
void PairFriction<Dim>::linearise(const Points<Dim>& all) {
  friction_.linearise(ways(all));
  look_at(all);
}

// Of the first facet of each pair over its second.
template <int Dim>
Points<Dim> PairFriction<Dim>::ways(const Points<Dim>& all) const {
  Points<Dim> ways(pairs_.size(), Point<Dim>::Zero());
  for (std::size_t r = 0; r < ways.size(); ++r)
    for (std::size_t i = 0; i < pair_markers<Dim>; ++i) {
      const std::size_t marker = pairs_[r].facets.markers[i];
      ways[r] += pairs_[r].gap.shares[i] * (all[marker] - starts_[marker]);
    }
  return ways;
}

template class PairFriction<2>;
template class PairFriction<3>;

}  // namespace washfsi
