// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/grid/grid.hpp"

namespace washfsi::test {

/// All values of a global field on every rank of the world, x first, components together. Ranks whose grid is their
/// own alone must not add up: `everywhere` says that the grid's ranks are those of the world. Collective.
template <int Dim, int Components>
std::vector<double> gather(const Grid<Dim>& grid, DM dm, Vec field, bool everywhere = true) {
  std::vector<double> all(Components * static_cast<std::size_t>(grid.cell_count()), 0.0);
  const View<Dim, Components, const double> view(dm, field);
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    std::size_t position = 0;
    for (std::size_t d = Dim; d-- > 0;)
      position = position * static_cast<std::size_t>(grid.cells()[d]) + static_cast<std::size_t>(cell[d]);
    for (int c = 0; c < Components; ++c) all[Components * position + static_cast<std::size_t>(c)] = view(cell, c);
  });
  if (everywhere)
    MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return all;
}

}  // namespace washfsi::test
