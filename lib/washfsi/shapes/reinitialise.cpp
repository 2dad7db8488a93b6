// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/reinitialise.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

double sign_of(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// The values around one cell along one axis. Beyond the box the field goes on straight.
struct Neighbours {
  double lower, here, upper;

  bool change_sign() const { return lower * here < 0 || upper * here < 0; }
  double backward() const { return here - lower; }
  double forward() const { return upper - here; }
};

template <int Dim>
Neighbours neighbours(const Grid<Dim>& grid, const ConstCellView<Dim>& phi, const Index<Dim>& cell, int axis) {
  const bool first = !grid.periodic(axis) && cell[axis] == 0;
  const bool last = !grid.periodic(axis) && cell[axis] == grid.cells()[axis] - 1;
  const double here = phi(cell);
  double lower = first ? here : phi(shifted<Dim>(cell, axis, -1));
  double upper = last ? here : phi(shifted<Dim>(cell, axis, 1));
  if (first) lower = 2 * here - upper;
  if (last) upper = 2 * here - lower;
  return {lower, here, upper};
}

// Size of the gradient from the differences on the side that the distance comes from.
template <int Dim>
double upwind_slope(const Grid<Dim>& grid, const ConstCellView<Dim>& phi, const Index<Dim>& cell, double sign) {
  double sum = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const Neighbours at = neighbours<Dim>(grid, phi, cell, axis);
    const double rise = std::max({sign * at.backward(), -sign * at.forward(), 0.0}) / grid.spacing()[axis];
    sum += rise * rise;
  }
  return std::sqrt(sum);
}

// Distance of a cell beside the zero level from it: the value over the gradient, which takes the steepest of the
// differences lest a kink makes it vanish.
template <int Dim>
double subcell_distance(const Grid<Dim>& grid, const ConstCellView<Dim>& phi, const Index<Dim>& cell) {
  double sum = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const Neighbours at = neighbours<Dim>(grid, phi, cell, axis);
    const double steepest =
        std::max({0.5 * std::abs(at.upper - at.lower), std::abs(at.forward()), std::abs(at.backward())}) /
        grid.spacing()[axis];
    sum += steepest * steepest;
  }
  return phi(cell) / std::sqrt(sum);
}

/// A cell beside the zero level, which is drawn to its own distance instead of its neighbours.
template <int Dim>
struct Anchor {
  Index<Dim> cell;
  double distance;
};

template <int Dim>
std::vector<Anchor<Dim>> anchors(const Grid<Dim>& grid, Vec level_set) {
  const petsc::LocalVector local(grid.stencil_dm(), level_set);
  const ConstCellView<Dim> phi(grid.stencil_dm(), local);
  std::vector<Anchor<Dim>> anchors;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    bool beside = false;
    for (int axis = 0; axis < Dim; ++axis) beside = beside || neighbours<Dim>(grid, phi, cell, axis).change_sign();
    if (beside) anchors.push_back({cell, subcell_distance<Dim>(grid, phi, cell)});
  });
  return anchors;
}

// One Euler step of all cells, the anchors included.
template <int Dim>
void step_upwind(const Grid<Dim>& grid, Vec signs, Vec level_set, double dt) {
  const petsc::LocalVector local(grid.stencil_dm(), level_set);
  const ConstCellView<Dim> phi(grid.stencil_dm(), local), sign(grid.cell_dm(), signs);
  const CellView<Dim> next(grid.cell_dm(), level_set);
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    next(cell) = phi(cell) + dt * sign(cell) * (1 - upwind_slope<Dim>(grid, phi, cell, sign(cell)));
  });
}

}  // namespace

template <int Dim>
void reinitialise(const Grid<Dim>& grid, Vec level_set, double reach, ZeroLevel zero_level) {
  const double smallest = grid.spacing().minCoeff(), dt = 0.5 * smallest;
  const auto steps = static_cast<int>(std::ceil(2 * reach / dt));  // the front, and as much again for its tail
  const petsc::Vector signs = grid.cell_vector();
  {
    const ConstCellView<Dim> start(grid.cell_dm(), level_set);
    const CellView<Dim> sign(grid.cell_dm(), signs);
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) { sign(cell) = sign_of(start(cell)); });
  }
  std::vector<Anchor<Dim>> fixed;
  if (zero_level == ZeroLevel::kept) fixed = anchors<Dim>(grid, level_set);
  for (int n = 0; n < steps; ++n) {
    // the anchors' equation, dPhi/dt* = (distance - Phi)/h, has the distance as its steady state: it is taken at once
    const auto hold = [&] {
      const CellView<Dim> phi(grid.cell_dm(), level_set);
      for (const auto& [cell, distance] : fixed) phi(cell) = distance;
    };
    if (n == 0) hold();
    step_upwind<Dim>(grid, signs, level_set, dt);
    hold();
  }
}

template void reinitialise<2>(const Grid<2>&, Vec, double, ZeroLevel);
template void reinitialise<3>(const Grid<3>&, Vec, double, ZeroLevel);

}  // namespace washfsi
