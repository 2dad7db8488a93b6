// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <mpi.h>

namespace washfsi {

/// The contact distances of pairs of things, which have numbers. Things that start nearer to each other than the usual
/// distance have a smaller one: that at which they start, so that contact does not throw them apart. It grows as they
/// separate, and never shrinks. All ranks have the same distances.
class PairDistances {
 public:
  using Pair = std::pair<std::size_t, std::size_t>;
  /// The distance of each pair of things that a rank sees nearer than usual [m]. The lesser number comes first.
  using Nearest = std::map<Pair, double>;

  explicit PairDistances(double usual) : usual_(usual) {}

  double usual() const { return usual_; }
  double of(std::size_t one, std::size_t other) const {
    if (less_.empty()) return usual_;
    const auto place = less_.find(std::minmax(one, other));
    return place == less_.end() ? usual_ : place->second;
  }
  /// Whether the things have started.
  bool has_started() const { return has_started_; }
  /// The pairs with a contact distance smaller than usual.
  const Nearest& less() const { return less_; }

  /// Sets the initial distances of the things. Collective.
  void start(MPI_Comm comm, const Nearest& nearest);
  /// Updates them by the present distances. Pairs that no rank sees are farther apart than their contact distance by
  /// `beyond` [m]. Collective.
  void follow(MPI_Comm comm, const Nearest& nearest, double beyond);

  /// The values for a restart: three numbers for each pair with a smaller distance, and a further one; none before the
  /// start.
  std::vector<double> stored() const;
  void restore(const std::vector<double>& stored);

 private:
  double usual_;
  bool has_started_ = false;
  Nearest less_;
};

/// Notes a distance of two things.
inline void note(PairDistances::Nearest& nearest, std::size_t one, std::size_t other, double distance) {
  const auto [place, is_new] = nearest.try_emplace(std::minmax(one, other), distance);
  if (!is_new && distance < place->second) place->second = distance;
}

}  // namespace washfsi
