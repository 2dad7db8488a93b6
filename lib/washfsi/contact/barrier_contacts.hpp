// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/contact/touch_friction.hpp"

namespace washfsi {

/// What touches, with its friction, as the markers move in a step. The search for it is valid while each marker stays
/// within its reach, and is repeated when one leaves this; what touches is kept for the places evaluated last.
template <int Dim>
class BarrierContacts {
 public:
  /// The contact distances and the cloths must outlive it. Collective.
  BarrierContacts(const BarrierOptions& options, PairDistances& distances, const Surroundings<Dim>& around)
      : comm_(around.cloths.comm()),
        near_(options.stiffness, distances, around.cloths, periods_of<Dim>(around.grid)),
        friction_(options, around.cloths) {}

  /// Begins a step: searches, updates the contact distances of what started in contact, and begins its friction.
  /// Returns the places of all known markers [m]. Collective.
  Points<Dim> begin_step(const StepStart<Dim>& start);
  /// Makes the search valid for all places on this motion. Collective.
  void cover(const Points<Dim>& from, const Points<Dim>& motion);
  /// Linearises the friction for Newton's method at these places. Collective.
  void linearise(const Points<Dim>& positions);

  /// What touches at these places of this rank's markers, where the friction is evaluated too. Collective.
  const std::vector<Touch<Dim>>& at(const Points<Dim>& positions) const;
  /// What touched at the places evaluated last; nothing after a later search.
  const std::vector<Touch<Dim>>& last() const { return touches_; }
  /// The places of this rank's markers that were evaluated last, or those of a later search [m].
  const Points<Dim>& last_places() const { return seen_.size() == places_.size() ? seen_ : places_; }
  /// The friction at the places evaluated last.
  const PairFriction<Dim>& friction() const { return friction_; }

  /// The result of the search: what may touch.
  const BarrierTouches<Dim>& near() const { return near_; }
  /// The markers that the search has made known.
  const NearMarkers<Dim>& known() const { return near_.search().known(); }
  /// The values of all known markers, from those of this rank's. Collective.
  Points<Dim> values(const Points<Dim>& own) const { return known().values(own); }
  /// Calls visit(index in `facing`, index among this rank's markers).
  template <class Visit>
  void visit_own(const Facing<Dim>& facing, const Visit& visit) const {
    const NearMarkers<Dim>& markers = known();
    for (std::size_t i = 0; i < facing.count; ++i)
      if (markers.owns(facing.markers[i])) visit(i, facing.markers[i] - markers.begin());
  }

 private:
  void search_at_start(const Points<Dim>& positions);
  void search_ahead(const StepStart<Dim>& start);
  void search(const Points<Dim>& positions, Before before = Before::forget);
  bool covers(const Points<Dim>& positions) const;
  double farthest_from_places(const Points<Dim>& positions) const;

  MPI_Comm comm_;
  BarrierTouches<Dim> near_;
  mutable TouchFriction<Dim> friction_;

  bool has_searched_ = false;
  Points<Dim> places_;           ///< places of this rank's markers at the last search [m]
  std::vector<double> reaches_;  ///< largest distances from there for which the search is valid [m]

  mutable Points<Dim> seen_;  ///< places of this rank's markers for which the touches are known [m]
  mutable std::vector<Touch<Dim>> touches_;
};

extern template class BarrierContacts<2>;
extern template class BarrierContacts<3>;

}  // namespace washfsi
