// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

/// The facets of all cloths in blocks, each of which begins at some consecutive markers of one cloth. A rank knows the
/// blocks of all ranks, and finds by their boxes which markers of others are near to its own.
template <int Dim>
class FacetBlocks {
 public:
  /// The cloths must outlive it. Collective.
  FacetBlocks(const Cloths<Dim>& cloths, const PeriodicSpace<Dim>& space);

  /// The numbers of the markers of all blocks that may come as near as `distance` to one of this rank's, while each
  /// marker moves from its place by its reach at most [m]; some more than once. Places and reaches are those of this
  /// rank's markers. Collective.
  std::vector<std::size_t> markers_near(const Points<Dim>& positions, const std::vector<double>& reaches,
                                        double distance) const;

 private:
  /// Consecutive markers of one cloth, at which facets begin.
  struct Block {
    std::size_t piece, first, end;
  };
  std::vector<Block> own_blocks() const;
  std::vector<Bounds<Dim>> own_boxes(const Points<Dim>& positions, const std::vector<double>& reaches,
                                     double distance) const;
  std::vector<Bounds<Dim>> of_all_blocks(const std::vector<Bounds<Dim>>& own) const;
  void add_markers(const Block& block, std::vector<std::size_t>& markers) const;

  const Cloths<Dim>& cloths_;
  PeriodicSpace<Dim> space_;
  std::vector<Block> blocks_;         ///< blocks of all ranks, in rank order
  std::vector<int> counts_, starts_;  ///< counts and starts of each rank's values in the exchange of boxes
};

extern template class FacetBlocks<2>;
extern template class FacetBlocks<3>;

}  // namespace washfsi
