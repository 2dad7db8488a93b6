// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "washfsi/grid/index.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// The parameters of a grid.
template <int Dim>
struct GridShape {
  Index<Dim> cells{};                     ///< number of cells in each direction
  Point<Dim> lower = Point<Dim>::Zero();  ///< [m]
  Point<Dim> upper = Point<Dim>::Ones();  ///< [m]
  std::array<bool, Dim> periodic{};
  Point<Dim> spacing() const {  ///< [m]
    Point<Dim> spacing = upper - lower;
    for (int d = 0; d < Dim; ++d) spacing[d] /= static_cast<double>(cells[d]);
    return spacing;
  }
  PetscInt ghost_width = 3;  ///< layers of ghosts where they are wide: delta half width + 1, at least 2
};

/// The box of equal cells: where its cells and faces are. A cell owns its lower faces.
template <int Dim>
class GridGeometry {
 public:
  /// Errors: InputError if there are fewer cells than layers of ghosts in a direction, or the box has no volume.
  explicit GridGeometry(const GridShape<Dim>& shape);

  const Index<Dim>& cells() const { return shape_.cells; }
  const Point<Dim>& lower() const { return shape_.lower; }
  const Point<Dim>& upper() const { return shape_.upper; }
  bool periodic(int axis) const { return shape_.periodic[axis]; }
  PetscInt ghost_width() const { return shape_.ghost_width; }
  const Point<Dim>& spacing() const { return spacing_; }  ///< [m]
  double cell_volume() const { return spacing_.prod(); }  ///< [m^Dim]
  double cell_count() const;

  Point<Dim> cell_center(const Index<Dim>& cell) const {
    Point<Dim> center;
    for (int d = 0; d < Dim; ++d) center[d] = shape_.lower[d] + (static_cast<double>(cell[d]) + 0.5) * spacing_[d];
    return center;
  }
  Point<Dim> face_center(const Index<Dim>& face, int axis) const {
    Point<Dim> center = cell_center(face);
    center[axis] -= 0.5 * spacing_[axis];
    return center;
  }
  /// A point, or its image in the box along periodic directions.
  Point<Dim> folded(Point<Dim> point) const;
  /// The cell that contains a point; periodic images are folded into the box.
  Index<Dim> cell_of(const Point<Dim>& point) const;
  /// The cell of the box for an index beyond it: its periodic image, or the nearest cell.
  Index<Dim> inside(Index<Dim> cell) const;
  /// Whether a point lies in the box (always, along periodic directions).
  bool contains(const Point<Dim>& point) const;

 private:
  GridShape<Dim> shape_;
  Point<Dim> spacing_;
};

extern template class GridGeometry<2>;
extern template class GridGeometry<3>;

}  // namespace washfsi
