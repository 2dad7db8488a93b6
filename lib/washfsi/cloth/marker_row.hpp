// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// Where the markers of a cloth are: `centred`, each in the middle of an equal part, the outermost half a spacing
/// within the edges; or `nodal`, the outermost on the edges, with half a part each.
enum class MarkerLattice { centred, nodal };
const ChoiceNames<MarkerLattice>& names_of(MarkerLattice);

/// How the markers along one side of a cloth divide it. What a marker or an edge stands for is the product of its
/// shares along s and r, times ds dr. A single marker has all of the side, whatever the lattice.
class MarkerRow {
 public:
  MarkerRow(MarkerLattice lattice, std::size_t count)
      : last_(count - 1), is_nodal_(lattice == MarkerLattice::nodal && count > 1) {}

  /// Length of the side over the spacing.
  double parts() const { return static_cast<double>(is_nodal_ ? last_ : last_ + 1); }
  /// Length that a marker stands for, over the spacing.
  double share(std::size_t marker) const { return is_nodal_ && (marker == 0 || marker == last_) ? 0.5 : 1; }
  /// Where a marker is along the side, 0 to 1.
  double place(std::size_t marker) const { return (static_cast<double>(marker) + (is_nodal_ ? 0 : 0.5)) / parts(); }
  /// Spacings by which the side extends beyond its outermost markers, at either end.
  double overhang() const { return is_nodal_ ? 0 : 0.5; }

 private:
  std::size_t last_;
  bool is_nodal_;
};

}  // namespace washfsi
