// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "support/scoped_option.hpp"
#include "washfsi/fluid/cell_levels.hpp"
#include "washfsi/fluid/pressure.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

CellLine line_of(PetscInt cells, bool periodic = false) {
  CellLine line{{}, {cells}, periodic};
  for (PetscInt i = 0; i <= cells; ++i) line.edges.push_back(0.1 * static_cast<double>(i));
  return line;
}

TEST(CellLine, KeepsItsLastCellAboutAsWideAsTheOthers) {
  for (PetscInt n = 2; n < 300; ++n) {
    CellLine line = line_of(n);
    while (line.cells() > 3) {
      const CellLine coarse = line.coarsened();
      EXPECT_DOUBLE_EQ(coarse.edges.front(), line.edges.front());
      EXPECT_DOUBLE_EQ(coarse.edges.back(), line.edges.back());
      EXPECT_LE(std::abs(2 * coarse.cells() - line.cells()), 1);
      EXPECT_EQ(coarse.part_ends.back(), coarse.cells());
      const double ratio = coarse.width(coarse.cells() - 1) / coarse.width(0);
      EXPECT_GT(ratio, 0.6) << n;
      EXPECT_LT(ratio, 1.65) << n;
      line = coarse;
    }
  }
}

TEST(CellLine, InterpolatesLinearFunctionsExactly) {
  const CellLine coarse = line_of(31).coarsened().coarsened();
  const double first = coarse.middle(0), last = coarse.middle(coarse.cells() - 1);
  for (int i = 0; i < 155; ++i) {
    const double x = 0.01 + 0.02 * i;
    const CellLine::Place place = coarse.place(x);
    EXPECT_NEAR(place.weights[0] + place.weights[1], 1, 1e-14);
    const double found =
        place.weights[0] * coarse.middle(place.cells[0]) + place.weights[1] * coarse.middle(place.cells[1]);
    EXPECT_NEAR(found, std::clamp(x, first, last), 1e-12);
  }
}

TEST(CellLine, InterpolatesAcrossThePeriodicEnds) {
  const CellLine line = line_of(7, true).coarsened();  // widths 2, 2 and 3
  const CellLine::Place low = line.place(0.05), high = line.place(0.65);
  EXPECT_EQ(low.cells[1], 2);
  EXPECT_NEAR(low.weights[1], 0.05 / 0.25, 1e-12);
  EXPECT_EQ(high.cells[1], 0);
  EXPECT_NEAR(high.weights[1], 0.1 / 0.25, 1e-12);
}

TEST(CellLevel, NumbersCellsRankByRank) {
  GridShape<3> shape;
  shape.cells = {13, 17, 9};
  const Grid<3> grid(PETSC_COMM_WORLD, shape);
  const petsc::Vector vector = grid.cell_vector();
  PetscInt next = 0;
  WASH_PETSC(VecGetOwnershipRange(vector, &next, nullptr));
  CellLevel<3> level(grid);
  for_each<3>(grid.owned(), [&](const Index<3>& cell) { EXPECT_EQ(level.number(cell), next++); });
  for (; level.cell_count() > 1; level = level.coarsened()) {
    std::set<PetscInt> numbers;
    for_each<3>({{}, level.cells()}, [&](const Index<3>& cell) { numbers.insert(level.number(cell)); });
    EXPECT_EQ(numbers.size(), level.cell_count());
    EXPECT_EQ(*numbers.rbegin() + 1, level.cell_count());
  }
}

TEST(CellLevel, MakesCellsAsWideAsHigh) {
  GridShape<3> shape;
  shape.cells = {33, 33, 33};
  shape.upper = {3, 3, 1};
  const Grid<3> grid(PETSC_COMM_WORLD, shape);
  const CellLevel<3> first = CellLevel<3>(grid).coarsened(), second = first.coarsened();
  EXPECT_EQ(first.cells(), (Index<3>{33, 33, 16}));
  EXPECT_EQ(second.cells(), (Index<3>{16, 16, 8}));
}

double noise(double x) {
  const double y = std::sin(12.9898 * x) * 43758.5453;
  return y - std::floor(y) - 0.5;
}

/// A ball that is so many times as dense as what is round it.
template <int Dim>
void set_density(const Grid<Dim>& grid, double contrast, Vec density) {
  const FaceView<Dim> rho(grid.face_dm(), density);
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& face) {
    for (int c = 0; c < Dim; ++c) {
      const Point<Dim> x = (grid.face_center(face, c) - grid.lower()).cwiseQuotient(grid.upper() - grid.lower());
      rho(face, c) = (x.array() - 0.45).matrix().norm() < 0.3 ? 1000 * contrast : 1000;
    }
  });
}

/// A right side that has no mean, with noise from cell to cell and a long wave.
template <int Dim>
petsc::Vector right_side(const Grid<Dim>& grid) {
  petsc::Vector rhs = grid.cell_vector();
  {
    const CellView<Dim> r(grid.cell_dm(), rhs);
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
      const Point<Dim> x = (grid.cell_center(cell) - grid.lower()).cwiseQuotient(grid.upper() - grid.lower());
      r(cell) = noise(x[0] + 7 * x[1] + 43 * x[Dim - 1]) + std::cos(3 * x[0]);
    });
  }
  double sum = 0;
  WASH_PETSC(VecSum(rhs, &sum));
  WASH_PETSC(VecShift(rhs, -sum / grid.cell_count()));
  return rhs;
}

/// The iterations that lower the residual to 1e-8 of its first size.
template <int Dim>
PetscInt iterations(const GridShape<Dim>& shape, double contrast) {
  const ScopedOption type("-pressure_pc_type", "mg"), coarse("-pressure_mg_coarse_pc_type", nullptr),
      dense("-pressure_mg_coarse_redundant_pc_type", nullptr);
  const Grid<Dim> grid(PETSC_COMM_WORLD, shape);
  PressureSolver<Dim> poisson(grid);
  const petsc::Vector rhs = right_side(grid), phi = grid.cell_vector(), density = grid.face_vector();
  set_density(grid, contrast, density);
  poisson.set_density(density);
  double size = 0;
  WASH_PETSC(VecNorm(rhs, NORM_2, &size));
  return poisson.solve(rhs, 1e-8 * size, phi);
}

template <int Dim>
void expect_few_iterations(const GridShape<Dim>& shape) {
  EXPECT_LE(iterations(shape, 1), 9);
  EXPECT_LE(iterations(shape, 10), 12);
}

TEST(Multigrid, TakesAsManyIterationsOnAnyNumberOfCells) {
  for (const PetscInt n : {17, 30, 33, 65, 127}) expect_few_iterations<2>({{n, n}});
  for (const PetscInt n : {15, 17, 33}) expect_few_iterations<3>({{n, n, n}});
  EXPECT_LE(iterations<3>({{65, 65, 65}}, 1), 9);
}

TEST(Multigrid, SeesTheDensityOnAllLevels) {
  for (const PetscInt n : {17, 33, 65}) EXPECT_LE(iterations<2>({{n, n}}, 1000), 15);
  for (const PetscInt n : {17, 33}) EXPECT_LE(iterations<3>({{n, n, n}}, 1000), 15);
}

TEST(Multigrid, TakesAsManyIterationsInCellsOfAnyShape) {
  expect_few_iterations<3>({{33, 33, 33}, {0, 0, 0}, {3, 3, 1}});
  expect_few_iterations<3>({{45, 31, 18}, {0, 0, 0}, {1, 1, 1}});
  expect_few_iterations<3>({{151, 5, 7}, {0, 0, 0}, {30, 1, 1.4}});
  expect_few_iterations<2>({{127, 31}, {0, 0}, {1, 100}});
}

TEST(Multigrid, TakesAsManyIterationsOnPeriodicGrids) {
  expect_few_iterations<2>({{127, 31}, {0, 0}, {1, 1}, {true, false}});
  expect_few_iterations<3>({{45, 31, 18}, {0, 0, 0}, {4.5, 3.1, 1.8}, {true, true, false}});
  expect_few_iterations<3>({{17, 17, 17}, {0, 0, 0}, {1, 1, 1}, {true, true, true}});
}

TEST(Multigrid, TakesAsManyLevelsAsTheUserWants) {
  const GridShape<2> shape{{33, 31}};
  {
    const ScopedOption levels("-pressure_pc_mg_levels", "2");
    EXPECT_LE(iterations(shape, 1), 9);
  }
  for (const char* number : {"2.5", "9"}) {
    const ScopedOption levels("-pressure_pc_mg_levels", number);
    EXPECT_THROW(iterations(shape, 1), InputError) << number;
  }
}

}  // namespace
}  // namespace washfsi::test
