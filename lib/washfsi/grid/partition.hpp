// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

#include "washfsi/grid/index.hpp"

namespace washfsi {

/// The range of cells of a rank. Each axis is divided into ranges, of which ends(axis) gives the ends in ascending
/// order; ranks are counted along x first.
template <int Dim, class Ends>
Box<Dim> cells_of_rank(int rank, const Ends& ends) {
  Box<Dim> box;
  for (int d = 0; d < Dim; ++d) {
    const auto& of_axis = ends(d);
    const auto part = static_cast<std::size_t>(rank) % of_axis.size();
    rank /= static_cast<int>(of_axis.size());
    box.lower[d] = part == 0 ? 0 : of_axis[part - 1];
    box.upper[d] = of_axis[part];
  }
  return box;
}

/// The rank that has a cell.
template <int Dim, class Ends>
int rank_of_cell(const Index<Dim>& cell, const Ends& ends) {
  std::ptrdiff_t rank = 0;
  for (int d = Dim; d-- > 0;) {
    const auto& of_axis = ends(d);
    const auto part = std::upper_bound(of_axis.begin(), of_axis.end(), cell[d]) - of_axis.begin();
    rank = rank * static_cast<std::ptrdiff_t>(of_axis.size()) + part;
  }
  return static_cast<int>(rank);
}

}  // namespace washfsi
