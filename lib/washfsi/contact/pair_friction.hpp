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
    double limit;        ///< friction coefficient times normal force there [N; per unit depth in the plane]
    double damping = 0;  ///< as of a `FrictionPair`
    double stops = 0;    ///< as of a `FrictionPair`
    /// Where its markers start; in an explicit step where they would have come from [m].
    std::array<Point<Dim>, 2 * Dim> starts{};
  };

  /// A step of length dt from these places begins; dt = 0: nothing slides. The share is that of `Friction::begin`.
  void begin(std::vector<Pair> pairs, const Points<Dim>& starts, double dt, double share = 1);
  /// An explicit step, in which what is at these places slides as it does now; mobilities as in `ExplicitStep`.
  /// Collective.
  void begin_explicit(std::vector<Pair> pairs, const NearMarkers<Dim>& known, const Points<Dim>& all,
                      const Points<Dim>& velocities, const std::vector<double>& mobilities, double dt);
  /// The markers are known at other places now: place(where one was).
  template <class Place>
  void renumber(const Place& place) {
    for (Pair& pair : pairs_)
      for (std::size_t i = 0; i < pair.facing.count; ++i) pair.facing.markers[i] = place(pair.facing.markers[i]);
  }
  /// Newton's method goes on from these places.
  void linearise(const Points<Dim>& all);
  /// What `visit` gives is of these places.
  void look_at(const Points<Dim>& all) { forces_ = friction_.forces(ways(all)); }
  double dt() const { return friction_.dt(); }

  /// visit(what faced each other at the step's start, what they do)
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
