// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/reinitialise.hpp"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "support/gather.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

/// An ellipse (ellipsoid) whose level set is far from a distance: its slope varies by more than a factor of 10
/// (after Russo and Smereka's test).
template <int Dim>
struct Ellipse {
  static Point<Dim> axes() {
    Point<Dim> axes = Point<Dim>::Constant(0.5);
    axes[0] = 0.8;
    return axes;
  }
  static double shape(const Point<Dim>& x) { return x.cwiseQuotient(axes()).norm() - 1; }
  static double level_set(const Point<Dim>& x) {
    return shape(x) * (0.1 + (x - Point<Dim>::Constant(0.7)).squaredNorm());
  }
  /// Distance of a place close to the surface from it.
  static double distance(const Point<Dim>& x) {
    const Point<Dim> scaled = x.cwiseQuotient(axes());
    return shape(x) * scaled.norm() / scaled.cwiseQuotient(axes()).norm();
  }
};

template <int Dim>
GridShape<Dim> cube(PetscInt n) {
  GridShape<Dim> shape;
  shape.cells.fill(n);
  shape.lower.setConstant(-1.03);
  shape.upper.setConstant(0.97);
  return shape;
}

template <int Dim>
petsc::Vector ellipse(const Grid<Dim>& grid) {
  petsc::Vector level_set = grid.cell_vector();
  const CellView<Dim> phi(grid.cell_dm(), level_set);
  for_each<Dim>(grid.owned(),
                [&](const Index<Dim>& cell) { phi(cell) = Ellipse<Dim>::level_set(grid.cell_center(cell)); });
  return level_set;
}

/// Of a level set beside the zero level, which is looked for on the lines between neighbouring cells.
struct Errors {
  double level = 0;  ///< largest distance of the zero level from where it was [m]
  double slope = 0;  ///< root mean square of |grad Phi| - 1 within 3 cells of the zero level
};

template <int Dim>
Errors errors(const Grid<Dim>& grid, Vec level_set) {
  const petsc::LocalVector local(grid.stencil_dm(), level_set);
  const ConstCellView<Dim> phi(grid.stencil_dm(), local);
  double level = 0, sum = 0, count = 0;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    double slope2 = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      const auto axis = static_cast<int>(d);
      if (cell[d] == 0 || cell[d] == grid.cells()[d] - 1) return;
      const double here = phi(cell), next = phi(shifted<Dim>(cell, axis, 1));
      const double rise = (next - phi(shifted<Dim>(cell, axis, -1))) / (2 * grid.spacing()[axis]);
      slope2 += rise * rise;
      if (here * next >= 0) continue;
      const Point<Dim> crossing =
          grid.cell_center(cell) + here / (here - next) * grid.spacing()[axis] * Point<Dim>::Unit(axis);
      level = std::max(level, std::abs(Ellipse<Dim>::distance(crossing)));
    }
    if (std::abs(phi(cell)) > 3 * grid.spacing()[0]) return;
    sum += (std::sqrt(slope2) - 1) * (std::sqrt(slope2) - 1);
    count += 1;
  });
  return {largest(grid.comm(), level),
          std::sqrt(ordered_sum(grid.comm(), sum) / std::max(ordered_sum(grid.comm(), count), 1.0))};
}

template <int Dim>
Errors after(PetscInt n, ZeroLevel zero_level, double reach) {
  const Grid<Dim> grid(PETSC_COMM_WORLD, cube<Dim>(n));
  const petsc::Vector level_set = ellipse<Dim>(grid);
  reinitialise<Dim>(grid, level_set, reach, zero_level);
  const Errors found = errors<Dim>(grid, level_set);
  if (rank_of(PETSC_COMM_WORLD) == 0)
    std::printf("%dD, %3d cells, %s: zero level moved by %.2e, slope wrong by %.2e\n", Dim, static_cast<int>(n),
                zero_level == ZeroLevel::kept ? "kept" : "free", found.level, found.slope);
  return found;
}

template <int Dim>
void expect_level_kept_at_second_order(PetscInt coarse, int refinements) {
  Errors before{}, drift{};
  for (int k = 0; k <= refinements; ++k) {
    const PetscInt n = coarse << k;
    const Errors kept = after<Dim>(n, ZeroLevel::kept, 0.5), free = after<Dim>(n, ZeroLevel::free, 0.5);
    EXPECT_GT(free.level, 4 * kept.level);
    EXPECT_LT(kept.slope, 0.1);
    if (k > 0) {
      EXPECT_GT(before.level / kept.level, 3);
      EXPECT_LT(kept.slope, 0.7 * before.slope);
      EXPECT_LT(drift.level / free.level, 3);
    }
    before = kept;
    drift = free;
  }
}

TEST(Reinitialise, KeepsTheZeroLevelAtSecondOrder) {
  expect_level_kept_at_second_order<2>(32, 2);
  expect_level_kept_at_second_order<3>(24, 1);
}

TEST(Reinitialise, LeavesADistanceAlone) {
  const Grid<2> grid(PETSC_COMM_WORLD, cube<2>(40));
  const petsc::Vector level_set = grid.cell_vector(), moved = grid.cell_vector();
  {
    const CellView<2> phi(grid.cell_dm(), level_set);
    const Point<2> normal = Point<2>(0.6, 0.8);
    for_each<2>(grid.owned(), [&](const Index<2>& cell) { phi(cell) = normal.dot(grid.cell_center(cell)) - 0.1; });
  }
  WASH_PETSC(VecCopy(level_set, moved));
  reinitialise<2>(grid, moved, 1);
  WASH_PETSC(VecAXPY(moved, -1, level_set));
  double largest = 0;
  WASH_PETSC(VecNorm(moved, NORM_INFINITY, &largest));
  EXPECT_LE(largest, 1e-13);
}

template <int Dim>
void expect_same_on_any_ranks(PetscInt n) {
  const Grid<Dim> shared(PETSC_COMM_WORLD, cube<Dim>(n)), own(PETSC_COMM_SELF, cube<Dim>(n));
  const petsc::Vector on_all = ellipse<Dim>(shared), on_one = ellipse<Dim>(own);
  reinitialise<Dim>(shared, on_all, 0.4);
  reinitialise<Dim>(own, on_one, 0.4);
  EXPECT_EQ((gather<Dim, 1>(shared, shared.cell_dm(), on_all)), (gather<Dim, 1>(own, own.cell_dm(), on_one, false)));
}

TEST(Reinitialise, GivesTheSameBitsOnAnyRanks) {
  expect_same_on_any_ranks<2>(30);
  expect_same_on_any_ranks<3>(16);
}

}  // namespace
}  // namespace washfsi::test
