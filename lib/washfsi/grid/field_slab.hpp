// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/support/slab.hpp"

namespace washfsi {

/// This rank's part of a dataset over the box `whole`, of which it has `part`, with `components` values per cell.
template <int Dim>
Slab box_slab(const Box<Dim>& whole, const Box<Dim>& part, int components) {
  Slab slab;
  for (int d = Dim; d-- > 0;) {
    slab.shape.push_back(static_cast<hsize_t>(whole.upper[d] - whole.lower[d]));
    slab.offset.push_back(static_cast<hsize_t>(part.lower[d] - whole.lower[d]));
    slab.count.push_back(static_cast<hsize_t>(part.upper[d] - part.lower[d]));
  }
  return with_components(slab, components);
}

/// This rank's part of a field with `components` values per cell in a dataset of shape [nz,] ny, nx [, components]. The
/// order is that of a DMDA's global vector. No last dimension for a single component.
template <int Dim>
Slab field_slab(const Grid<Dim>& grid, int components) {
  return box_slab<Dim>({{}, grid.cells()}, grid.owned(), components);
}

}  // namespace washfsi
