// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"

namespace washfsi::test {

/// The unit square or cube in n cells a side.
template <int Dim>
Grid<Dim> unit_grid(PetscInt n) {
  GridShape<Dim> shape;
  shape.cells.fill(n);
  shape.lower.setZero();
  shape.upper.setOnes();
  return Grid<Dim>(PETSC_COMM_WORLD, shape);
}

}  // namespace washfsi::test
