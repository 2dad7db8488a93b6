// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/friction.hpp"
#include "washfsi/contact/pair_search.hpp"

namespace washfsi {

/// Friction between parts of cloths that touch when a step begins, of which each has a marker of this rank. Places and
/// velocities are those of all markers that it knows.
template <int Dim>
class PairFriction {
 public:
  struct Pair {
    Facing<Dim> facing;  ///< at the step's start
    double limit;        ///< mu_C F_n there [N; per unit depth in 2D]
    double damping = 0;  ///< as in `FrictionPair`
    double stops = 0;    ///< as in `FrictionPair`
    /// Initial places of its markers; in an explicit step the places from which they would have come [m].
    std::array<Point<Dim>, 2 * Dim> starts{};
  };

  /// Begins a step of length dt from these places; dt = 0: nothing slides. `share` is that of `Friction::begin`.
  void begin(std::vector<Pair> pairs, const Points<Dim>& starts, double dt, double share = 1);
  /// Begins an explicit step, in which pairs at these places slide as they do now; mobilities as in `ExplicitStep`.
  /// Collective.
  void begin_explicit(std::vector<Pair> pairs, const NearMarkers<Dim>& known, const Points<Dim>& all,
                      const Points<Dim>& velocities, const std::vector<double>& mobilities, double dt);
  /// Renumbers the known markers: place(old index) is the new one.
  template <class Place>
  void renumber(const Place& place) {
    for (Pair& pair : pairs_)
      for (std::size_t i = 0; i < pair.facing.count; ++i) pair.facing.markers[i] = place(pair.facing.markers[i]);
  }
  /// Linearises for Newton's method at these places.
  void linearise(const Points<Dim>& all);
  /// Sets the places for `visit`.
  void look_at(const Points<Dim>& all) { forces_ = friction_.forces(ways(all)); }
  double dt() const { return friction_.dt(); }

  /// Calls visit(facing at the step's start, friction force).
  template <class Visit>
  void visit(const Visit& visit) const {
    for (std::size_t r = 0; r < forces_.size(); ++r) visit(pairs_[r].facing, forces_[r]);
  }

 private:
  Points<Dim> ways(const Points<Dim>& all) const;
  static void set_stops(std::vector<Pair>& pairs, const NearMarkers<Dim>& known, const std::vector<double>& mobilities,
                        double dt);

  std::vector<Pair> pairs_;
  Friction<Dim> friction_;
  std::vector<FrictionForce<Dim>> forces_;
};

extern template class PairFriction<2>;
extern template class PairFriction<3>;

}  // namespace washfsi
