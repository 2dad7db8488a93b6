// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// The share of fluid in cells: the mean of the shares of a cell's faces. A face in an upper side of the box, which no
/// global vector contains, counts as the one across the cell.
template <int Dim>
class CellShare {
 public:
  /// `fluid_share` is on the grid's faces, global; null: all is fluid. Collective.
  CellShare(const Grid<Dim>& grid, Vec fluid_share) : grid_(grid), local_(grid.face_dm()) {
    if (fluid_share)
      WASH_PETSC(DMGlobalToLocal(grid.face_dm(), fluid_share, INSERT_VALUES, local_));
    else
      WASH_PETSC(VecSet(local_, 1.0));
    share_.emplace(grid.face_dm(), local_);
  }

  /// The share of a cell of this rank.
  double operator()(const Index<Dim>& cell) const {
    double sum = 0;
    for (int d = 0; d < Dim; ++d) {
      const double below = (*share_)(cell, d);
      const bool at_side = !grid_.periodic(d) && cell[d] == grid_.cells()[d] - 1;
      sum += below + (at_side ? below : (*share_)(shifted<Dim>(cell, d, 1), d));
    }
    return sum / (2 * Dim);
  }

 private:
  const Grid<Dim>& grid_;
  petsc::LocalVector local_;
  std::optional<ConstFaceView<Dim>> share_;  ///< destroyed before the vector that it views
};

}  // namespace washfsi
