// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "washfsi/cloth/marker_numbering.hpp"
#include "washfsi/cloth/options.hpp"
#include "washfsi/support/contiguous_type.hpp"

namespace washfsi {

/// The MPI type of a Point<Dim>, for the exchange of marker data.
template <int Dim>
struct PointType : ContiguousType {
  PointType() : ContiguousType(Dim, MPI_DOUBLE) {}
};

/// The rows of a cloth that a rank sees: those of its own markers and `sheet_reach` more on either side. A closed cloth
/// is seen as an open one that goes round beyond its own end.
struct LatticePart {
  std::size_t piece;
  std::vector<PetscInt> markers;              ///< markers seen, by their numbers
  std::size_t first_in_halo;                  ///< index of the first in an array with halo
  std::size_t own_begin, own_end, own_first;  ///< range of this rank's among them, and index of the first in its arrays

  /// The values of its markers in an array with halo.
  template <class Value>
  std::span<const Value> seen(const std::vector<Value>& with_halo) const {
    return std::span<const Value>(with_halo).subspan(first_in_halo, markers.size());
  }
};

/// Calls add(part, sums of its markers, zero at first) for some parts and adds the sums of this rank's markers.
template <int Dim, class Add>
void add_by_part(const std::vector<LatticePart>& parts, Points<Dim>& sums, const Add& add) {
  for (const LatticePart& part : parts) {
    Points<Dim> of_part(part.markers.size(), Point<Dim>::Zero());
    add(part, std::span<Point<Dim>>(of_part));
    for (std::size_t i = part.own_begin; i < part.own_end; ++i) sums[part.own_first + i - part.own_begin] += of_part[i];
  }
}

/// The parts of the cloths that a rank sees, for forces between neighbours on a lattice. An array with halo has a value
/// for each marker of each part.
template <int Dim>
class SeenLattices {
 public:
  /// Collective.
  SeenLattices(const MarkerNumbering& numbering, const std::vector<ClothGroup<Dim>>& groups);

  const std::vector<LatticePart>& parts() const { return parts_; }
  /// This rank's values and those of the other markers that it sees. Collective.
  Points<Dim> with_halo(const Points<Dim>& values) const;
  std::vector<double> with_halo(const std::vector<double>& values) const;

 private:
  std::vector<LatticePart> parts_;
  std::size_t halo_count_ = 0;
  PointType<Dim> point_type_;
  petsc::StarForest halo_;  ///< from the owners to the markers seen
};

extern template class SeenLattices<2>;
extern template class SeenLattices<3>;

}  // namespace washfsi
