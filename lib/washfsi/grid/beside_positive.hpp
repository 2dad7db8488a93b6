// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "washfsi/grid/view.hpp"

namespace washfsi {

/// The smallest box containing those of these cells that have faces where a field is positive, or are beside such
/// faces. The field is local, with ghosts round the cells.
template <int Dim>
Box<Dim> beside_positive(const Box<Dim>& cells, const ConstFaceView<Dim>& field) {
  Box<Dim> found{cells.upper, cells.lower};
  for_each<Dim>(cells.widened(), [&](const Index<Dim>& cell) {
    double sum = 0;
    for (int c = 0; c < Dim; ++c) sum += field(cell, c);
    if (sum > 0)
      for (int d = 0; d < Dim; ++d) {
        found.lower[d] = std::min(found.lower[d], cell[d] - 1);
        found.upper[d] = std::max(found.upper[d], cell[d] + 2);
      }
  });
  return found.common(cells);
}

}  // namespace washfsi
