// SPDX-License-Identifier: BSD-3-Clause
//
// The part of other ranks' cloths that a rank has to know: the markers whose facets may come near to facets of its own.
// Each rank tells all others the boxes of blocks of its facets, some for each hundred markers, and gets from their
// owners the values of the markers of those that overlap its own boxes. Nothing else of a cloth is known to all.
#pragma once

#include "washfsi/cloth/facet_blocks.hpp"

namespace washfsi {

/// Whether the markers known so far stay known when others are chosen.
enum class Before { forget, keep };

/// The markers that a rank knows: its own, and those of other ranks that are near. Arrays over known markers are in
/// ascending order of their numbers, so that this rank's are contiguous there too.
template <int Dim>
class NearMarkers {
 public:
  /// The cloths must outlive it. Collective.
  NearMarkers(const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space);

  /// Chooses the known markers: those of all facets that may come as near as `distance` to one of this rank's, while
  /// each marker moves from its place by its reach at most [m], and with `Before::keep` all known so far. Places and
  /// reaches are those of this rank's markers. Returns whether the markers of any rank have changed. Collective.
  bool choose(const Points<Dim>& positions, const std::vector<double>& reaches, double distance,
              Before before = Before::forget);

  /// The numbers of the known markers among those of all ranks.
  const std::vector<std::size_t>& numbers() const { return numbers_; }
  std::size_t size() const { return numbers_.size(); }
  /// The index of this rank's first marker among them; and whether a known marker is this rank's.
  std::size_t begin() const { return begin_; }
  bool owns(std::size_t known) const { return known >= begin_ && known < begin_ + cloths_.owned(); }
  /// The index of a number among them, or where it would be inserted.
  std::size_t place_of(std::size_t number) const;
  /// The cloth of a known marker.
  std::size_t piece_of(std::size_t known) const { return pieces_[known]; }

  /// The values of all known markers, from those of this rank's. Collective.
  Points<Dim> values(const Points<Dim>& own) const;
  std::vector<double> values(const std::vector<double>& own) const;
  /// This rank's part of the values of all known markers.
  template <class Values>
  Values own(const Values& of_known) const {
    const auto first = of_known.begin() + static_cast<std::ptrdiff_t>(begin_);
    return Values(first, first + static_cast<std::ptrdiff_t>(cloths_.owned()));
  }
  /// For each of this rank's markers, the sum of the values on all ranks that know it. Collective.
  Points<Dim> sums(const Points<Dim>& of_known) const;
  /// For each of this rank's markers, the least of the values on all ranks that know it. Collective.
  std::vector<double> least(const std::vector<double>& of_known) const;

 private:
  void know(std::vector<std::size_t> numbers);
  template <class Values>
  Values known(const Values& own, MPI_Datatype type) const;
  template <class Values>
  Values reduced(const Values& of_known, MPI_Datatype type, MPI_Op operation) const;

  const Cloths<Dim>& cloths_;
  FacetBlocks<Dim> blocks_;
  PointType<Dim> point_type_;
  std::vector<std::size_t> numbers_, pieces_;
  std::size_t begin_ = 0;
  petsc::StarForest forest_;  ///< from the owners to the known markers of other ranks
};

extern template class NearMarkers<2>;
extern template class NearMarkers<3>;

}  // namespace washfsi
