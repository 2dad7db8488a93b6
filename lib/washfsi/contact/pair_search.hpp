// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "washfsi/contact/facets.hpp"
#include "washfsi/contact/gap.hpp"
#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

/// Two facets without a common marker that may come into contact.
template <int Dim>
struct FacetPair {
  PairKind kind;
  std::array<std::size_t, pair_markers<Dim>> markers;  ///< numbers among those of all ranks
  Point<Dim> shift;                                    ///< of the second facet's periodic image [m]
  double weight;    ///< undeformed area that the pair stands for [m2; m in the plane]
  double parallel;  ///< eps of the mollifier [m4]; 0 where there is none
  double start;     ///< distance where it was found [m]

  /// The places of its markers among those of all, near to each other.
  PairPoints<Dim> at(const Points<Dim>& all) const {
    PairPoints<Dim> places;
    for (std::size_t i = 0; i < places.size(); ++i)
      places[i] = i < markers_of_first(kind) ? all[markers[i]] : Point<Dim>(all[markers[i]] + shift);
    return places;
  }

  /// Its markers' part of the motions of all.
  PairPoints<Dim> motions(const Points<Dim>& all) const {
    PairPoints<Dim> motions;
    for (std::size_t i = 0; i < motions.size(); ++i) motions[i] = all[markers[i]];
    return motions;
  }
};

/// Finds the pairs of facets that may come near to each other, of one cloth with itself too. Each rank finds those that
/// have a marker of its own. Their order depends on nothing but which they are.
template <int Dim>
class PairSearch {
 public:
  /// The facets must outlive it. `begin` to `end`: the markers of this rank.
  PairSearch(const Facets<Dim>& facets, const PeriodicSpace<Dim>& space, std::size_t begin, std::size_t end)
      : facets_(facets), space_(space), begin_(begin), end_(end) {}

  /// The pairs that may be as near as `distance`, while each of all markers moves from its place by its reach at most.
  std::vector<FacetPair<Dim>> find(const Points<Dim>& all, const std::vector<double>& reaches, double distance) const;

 private:
  struct Query;
  template <class Markers>
  bool is_own(const Markers& markers) const {
    return std::any_of(markers.begin(), markers.end(), [this](std::size_t m) { return m >= begin_ && m < end_; });
  }
  template <class Facet>
  std::vector<std::size_t> own(const std::vector<Facet>& facets) const;
  void find_points_and_faces(const Query& query, std::vector<FacetPair<Dim>>& found) const;
  void find_edges(const Query& query, std::vector<FacetPair<Dim>>& found) const;
  void keep_if_near(const Query& query, FacetPair<Dim> pair, std::vector<FacetPair<Dim>>& found) const;
  Point<Dim> shift_of(const FacetPair<Dim>& pair, const Points<Dim>& all) const;

  const Facets<Dim>& facets_;
  PeriodicSpace<Dim> space_;
  std::size_t begin_, end_;
};

extern template class PairSearch<2>;
extern template class PairSearch<3>;

}  // namespace washfsi
