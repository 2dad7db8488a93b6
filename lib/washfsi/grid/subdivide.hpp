// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// Divides a box of cells by their distance [m] from a surface: calls far(part, sign) for parts that lie farther than
/// `reach` from it, on its positive or negative side, and near(cell) for all other cells. A part is judged by the
/// distance of its middle, since a distance changes no faster than the place; so the effort grows with the surface, not
/// with the volume. A cell's faces belong to it. `distance(place)` may be smaller in size than the true one. The cells
/// are those of a `Grid`, or of anything else that has `lower` and `spacing`.
template <int Dim, class Cells, class Distance, class Far, class Near>
void subdivide(const Cells& grid, const Box<Dim>& box, double reach, const Distance& distance, const Far& far,
               const Near& near) {
  Point<Dim> middle, size;
  PetscInt longest = 0;
  std::size_t axis = 0;
  for (int d = 0; d < Dim; ++d) {
    const PetscInt cells = box.upper[d] - box.lower[d];
    if (cells <= 0) return;
    if (cells > longest) axis = d;
    longest = std::max(longest, cells);
    size[d] = static_cast<double>(cells) * grid.spacing()[d];
    middle[d] = grid.lower()[d] + 0.5 * static_cast<double>(box.lower[d] + box.upper[d]) * grid.spacing()[d];
  }
  const double from_middle = distance(middle);
  if (std::abs(from_middle) > reach + 0.5 * size.norm()) return far(box, from_middle > 0 ? 1 : -1);
  if (longest <= 2) return for_each<Dim>(box, near);
  Box<Dim> lower = box, upper = box;
  lower.upper[axis] = upper.lower[axis] = box.lower[axis] + longest / 2;
  subdivide(grid, lower, reach, distance, far, near);
  subdivide(grid, upper, reach, distance, far, near);
}

}  // namespace washfsi
