// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/grid_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "washfsi/support/errors.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi {

namespace {

template <int Dim>
void check_shape(const GridShape<Dim>& shape) {
  for (int d = 0; d < Dim; ++d)
    if (shape.cells[d] < shape.ghost_width)
      throw InputError("-grid_cells " + std::to_string(shape.cells[d]) + ": must be at least " +
                       std::to_string(shape.ghost_width) + " in each direction");
  for (int d = 0; d < Dim; ++d)
    if (!(shape.upper[d] > shape.lower[d]))
      throw InputError("-grid_upper " + list_text<Dim>(shape.upper) + ": must exceed -grid_lower " +
                       list_text<Dim>(shape.lower) + " in each direction");
}

}  // namespace

template <int Dim>
GridGeometry<Dim>::GridGeometry(const GridShape<Dim>& shape) : shape_(shape) {
  check_shape(shape_);
  spacing_ = shape_.spacing();
}

template <int Dim>
double GridGeometry<Dim>::cell_count() const {
  double count = 1;
  for (const PetscInt n : shape_.cells) count *= static_cast<double>(n);
  return count;
}

template <int Dim>
Point<Dim> GridGeometry<Dim>::folded(Point<Dim> point) const {
  for (int d = 0; d < Dim; ++d) {
    if (!periodic(d)) continue;
    const double length = upper()[d] - lower()[d];
    point[d] -= length * std::floor((point[d] - lower()[d]) / length);
  }
  return point;
}

template <int Dim>
Index<Dim> GridGeometry<Dim>::cell_of(const Point<Dim>& point) const {
  Index<Dim> cell;
  for (int d = 0; d < Dim; ++d) {
    cell[d] = static_cast<PetscInt>(std::floor((point[d] - shape_.lower[d]) / spacing_[d]));
  }
  return inside(cell);
}

template <int Dim>
Index<Dim> GridGeometry<Dim>::inside(Index<Dim> cell) const {
  for (int d = 0; d < Dim; ++d) {
    const PetscInt n = shape_.cells[d];
    cell[d] = shape_.periodic[d] ? ((cell[d] % n) + n) % n : std::clamp<PetscInt>(cell[d], 0, n - 1);
  }
  return cell;
}

template <int Dim>
bool GridGeometry<Dim>::contains(const Point<Dim>& point) const {
  for (int d = 0; d < Dim; ++d)
    if (!periodic(d) && !(point[d] > shape_.lower[d] && point[d] < shape_.upper[d])) return false;
  return true;
}

template class GridGeometry<2>;
template class GridGeometry<3>;

}  // namespace washfsi
