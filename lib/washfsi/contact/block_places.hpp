// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/marker_force.hpp"
#include "washfsi/contact/barrier_touches.hpp"

namespace washfsi {

/// The pattern of blocks of the barrier's stiffness in the rows of this rank's markers: those of what touches at some
/// places, or soon may. Contacts that arise during the solution of a step are left out except for their diagonal
/// blocks: the matrix stays positive.
template <int Dim>
class BlockPlaces {
 public:
  explicit BlockPlaces(const Cloths<Dim>& cloths) : cloths_(cloths) {}

  /// Makes the pattern for what touches at these places.
  void lay_out(const BarrierTouches<Dim>& touches, const Points<Dim>& all);
  /// A number that changes with the pattern.
  long pattern() const { return pattern_; }
  /// Whether blocks have been left out since the pattern was made.
  bool leaves_out() const { return leaves_out_; }

  std::vector<StiffnessBlock<Dim>> zeros() const { return {columns_.size(), StiffnessBlock<Dim>::Zero()}; }
  /// Adds block(i, j) for each two of the markers that face each other.
  template <class Block>
  void add(const Facing<Dim>& facing, const NearMarkers<Dim>& known, const Block& block,
           std::vector<StiffnessBlock<Dim>>& blocks) {
    for (std::size_t i = 0; i < facing.count; ++i) {
      if (!known.owns(facing.markers[i])) continue;
      for (std::size_t j = 0; j < facing.count; ++j) {
        const std::size_t place = place_of(facing.markers[i] - known.begin(), known.numbers()[facing.markers[j]]);
        if (place < blocks.size())
          blocks[place] += block(i, j);
        else
          leaves_out_ = true;
      }
    }
  }
  /// Calls `add` for all blocks in their order.
  void visit(const std::vector<StiffnessBlock<Dim>>& blocks, const AddMarkerBlock<Dim>& add) const;

 private:
  /// The index of a block; beyond the last one if the pattern lacks it.
  std::size_t place_of(std::size_t row, std::size_t column) const;

  const Cloths<Dim>& cloths_;
  std::vector<std::size_t> columns_, rows_{0};  ///< columns of the blocks in this rank's rows; starts of rows
  long pattern_ = 0;
  bool leaves_out_ = false;
};

extern template class BlockPlaces<2>;
extern template class BlockPlaces<3>;

}  // namespace washfsi
