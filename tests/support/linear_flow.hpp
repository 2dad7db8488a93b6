// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/boundary.hpp"

namespace washfsi::test {

/// Water in the unit square, in 8 x 6 cells, between walls that move with it: velocity (y, 2x) [m/s] and pressure
/// 3x - y [Pa]. Being linear, both are exact between faces, between cells and, the velocity, up to the walls.
struct LinearFlow {
  LinearFlow()
      : grid(PETSC_COMM_WORLD, shape()),
        boundary(grid, sides()),
        velocity(grid.face_vector()),
        pressure(grid.cell_vector()) {
    const FaceView<2> u(grid.face_dm(), velocity);
    const CellView<2> p(grid.cell_dm(), pressure);
    for_each<2>(grid.owned(), [&](const Index<2>& cell) {
      for (int c = 0; c < 2; ++c) u(cell, c) = velocity_at(grid.face_center(cell, c))[c];
      p(cell) = pressure_at(grid.cell_center(cell));
    });
  }

  static Point<2> velocity_at(const Point<2>& place) { return {place[1], 2 * place[0]}; }
  static double pressure_at(const Point<2>& place) { return 3 * place[0] - place[1]; }
  static constexpr double vorticity = 1;  ///< 2 - 1 [1/s]

  Grid<2> grid;
  Boundary<2> boundary;
  petsc::Vector velocity, pressure;

 private:
  static GridShape<2> shape() {
    GridShape<2> shape;
    shape.cells = {8, 6};
    return shape;
  }
  static Sides<2> sides() {
    Sides<2> sides;
    for (auto& axis : sides)
      for (auto& side : axis) side.motion = [](const Point<2>& place, double) { return velocity_at(place); };
    return sides;
  }
};

}  // namespace washfsi::test
