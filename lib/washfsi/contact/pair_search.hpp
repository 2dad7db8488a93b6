// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "washfsi/cloth/facets.hpp"
#include "washfsi/contact/gap.hpp"
#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

/// Two facets without a common marker that may come into contact.
template <int Dim>
struct FacetPair {
  PairKind kind;
  std::array<std::size_t, pair_markers<Dim>> markers;  ///< places among those that the rank knows
  Point<Dim> shift;                                    ///< of the second facet's periodic image [m]
  double weight;    ///< undeformed area that the pair stands for [m2; m in the plane]
  double parallel;  ///< eps of the mollifier [m4]; 0 where there is none
  double start;     ///< distance where it was found [m]

  /// The places of its markers, near to each other, by those of all that is known.
  PairPoints<Dim> at(const Points<Dim>& all) const {
    PairPoints<Dim> places;
    for (std::size_t i = 0; i < places.size(); ++i)
      places[i] = i < markers_of_first(kind) ? all[markers[i]] : Point<Dim>(all[markers[i]] + shift);
    return places;
  }

  /// Its markers' motions.
  PairPoints<Dim> motions(const Points<Dim>& all) const {
    PairPoints<Dim> motions;
    for (std::size_t i = 0; i < motions.size(); ++i) motions[i] = all[markers[i]];
    return motions;
  }
};

/// Finds the pairs of facets that may come near to each other, of one cloth with itself too. Each rank finds those that
/// have a marker of its own, and knows what is near to these. Their order depends on nothing but which they are.
template <int Dim>
class PairSearch {
 public:
  /// The cloths must outlive it. Collective.
  PairSearch(const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space)
      : cloths_(cloths), space_(space), known_(cloths, space), facets_(cloths, known_) {}

  /// The pairs that may be as near as `distance`, while each marker moves from its place by its reach at most; places
  /// and reaches are those of this rank's markers. What was known before stays known if it is to be kept, elsewhere
  /// perhaps. Collective.
  std::vector<FacetPair<Dim>> find(const Points<Dim>& positions, const std::vector<double>& reaches, double distance,
                                   Before before = Before::forget);

  /// The markers that the pairs are of, and their facets, until the next search.
  const NearMarkers<Dim>& known() const { return known_; }
  const Facets<Dim>& facets() const { return facets_; }

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
};

extern template class PairSearch<2>;
extern template class PairSearch<3>;

}  // namespace washfsi
