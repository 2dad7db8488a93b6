// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "washfsi/contact/surface_samples.hpp"

namespace washfsi {

/// Two facets without a common marker that may come into contact.
template <int Dim>
struct FacetPair {
  PairKind kind;
  std::array<std::size_t, pair_markers<Dim>> markers;  ///< indices among the markers that the rank knows
  Point<Dim> shift;                                    ///< shift of the second facet's periodic image [m]
  double weight;    ///< undeformed area that the pair stands for [m2; m in the plane]
  double parallel;  ///< eps of the factor eta of parallel edges [m4]; 0: none
  double start;     ///< distance when it was found [m]

  /// The places of its markers, shifted to be near to each other, from those of all known markers.
  PairPoints<Dim> at(const Points<Dim>& all) const {
    PairPoints<Dim> places;
    for (std::size_t i = 0; i < places.size(); ++i)
      places[i] = i < markers_of_first(kind) ? all[markers[i]] : Point<Dim>(all[markers[i]] + shift);
    return places;
  }

  /// The motions of its markers.
  PairPoints<Dim> motions(const Points<Dim>& all) const {
    PairPoints<Dim> motions;
    for (std::size_t i = 0; i < motions.size(); ++i) motions[i] = all[markers[i]];
    return motions;
  }
};

/// Finds the pairs of facets that may come near to each other, also within one cloth. Each rank finds those with a
/// marker of its own, and knows the markers near to these. The pairs' order depends only on which they are.
template <int Dim>
class PairSearch {
 public:
  /// The cloths must outlive it. Collective.
  PairSearch(const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space)
      : cloths_(cloths), space_(space), known_(cloths, space), facets_(cloths, known_) {}

  /// Gets all markers that may come as near as `distance` to a facet of this rank, while each marker moves from its
  /// place by its reach at most; places and reaches are those of this rank's markers. With `Before::keep` markers known
  /// so far stay known, perhaps at other indices. Collective.
  void find_near(const Points<Dim>& positions, const std::vector<double>& reaches, double distance,
                 Before before = Before::forget);
  /// The pairs of facets that may come as near as their contact distance, which must be at most `most`; this must not
  /// exceed the distance of the last `find_near`. No communication.
  std::vector<FacetPair<Dim>> pairs(const ContactDistance& distance, double most) const;
  /// The samples of surfaces likewise; `most` is at most half of the distance of the last `find_near`. No
  /// communication.
  std::vector<SurfaceSample<Dim>> samples(const ContactDistance& distance, double most) const {
    return find_samples<Dim>(known_, facets_, all_, reaches_, distance, most, space_);
  }

  /// The markers of the pairs, and their facets, valid until the next `find_near`.
  const NearMarkers<Dim>& known() const { return known_; }
  const Facets<Dim>& facets() const { return facets_; }
  /// The place of a marker at the last `find_near` [m].
  const Point<Dim>& place(std::size_t marker) const { return all_[marker]; }

 private:
  struct Query;
  template <class Markers>
  bool is_own(const Markers& markers) const {
    return std::any_of(markers.begin(), markers.end(), [this](std::size_t m) { return known_.owns(m); });
  }
  template <class Facet>
  std::vector<std::size_t> own(const std::vector<Facet>& facets) const;
  void find_points_and_faces(const Query& query, std::vector<FacetPair<Dim>>& found) const;
  void find_edges(const Query& query, std::vector<FacetPair<Dim>>& found) const;
  void keep_if_near(const Query& query, FacetPair<Dim> pair, std::vector<FacetPair<Dim>>& found) const;
  Point<Dim> shift_of(const FacetPair<Dim>& pair, const Points<Dim>& all) const;

  const Cloths<Dim>& cloths_;
  PeriodicSpace<Dim> space_;
  NearMarkers<Dim> known_;
  Facets<Dim> facets_;
  Points<Dim> all_;              ///< places of all known markers at the last `find_near` [m]
  std::vector<double> reaches_;  ///< their reaches from there [m]
};

extern template class PairSearch<2>;
extern template class PairSearch<3>;

}  // namespace washfsi
