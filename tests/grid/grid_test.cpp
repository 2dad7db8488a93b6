// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/grid.hpp"

#include <gtest/gtest.h>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
GridShape<Dim> shape_of(PetscInt n, bool periodic) {
  GridShape<Dim> shape;
  for (std::size_t d = 0; d < Dim; ++d) shape.cells[d] = n + static_cast<PetscInt>(d);
  shape.periodic.fill(periodic);
  return shape;
}

template <int Dim>
void expect_consistent_ownership() {
  const Grid<Dim> grid(PETSC_COMM_WORLD, shape_of<Dim>(11, false));
  double cells = 0;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    ++cells;
    EXPECT_EQ(grid.owner(cell), rank_of(PETSC_COMM_WORLD));
    EXPECT_EQ(grid.cell_of(grid.cell_center(cell)), cell);
  });
  EXPECT_EQ(ordered_sum(PETSC_COMM_WORLD, cells), grid.cell_count());
}

TEST(Grid, EachCellHasOneOwnerInThePlane) {
  expect_consistent_ownership<2>();
}
TEST(Grid, EachCellHasOneOwnerInSpace) {
  expect_consistent_ownership<3>();
}

TEST(Grid, PeriodicImagesFoldIntoTheBox) {
  const Grid<2> grid(PETSC_COMM_WORLD, shape_of<2>(10, true));
  EXPECT_EQ(grid.cell_of({1.05, -0.01}), (Index<2>{0, 10}));
  EXPECT_TRUE(grid.contains({7, -3}));
}

TEST(Grid, GhostsHoldTheNeighboursValues) {
  const Grid<3> grid(PETSC_COMM_WORLD, shape_of<3>(9, true));
  const petsc::Vector global = grid.face_vector();
  const auto label = [&](const Index<3>& i, int c) {
    return static_cast<double>((i[0] + 9) % 9 + 100 * ((i[1] + 10) % 10) + 10000 * ((i[2] + 11) % 11)) + 0.25 * c;
  };
  {
    const FaceView<3> view(grid.face_dm(), global);
    for_each<3>(grid.owned(), [&](const Index<3>& i) {
      for (int c = 0; c < 3; ++c) view(i, c) = label(i, c);
    });
  }
  const petsc::LocalVector local(grid.wide_face_dm(), global);
  const ConstFaceView<3> view(grid.wide_face_dm(), local);
  for_each<3>(grid.local(), [&](const Index<3>& i) {
    for (int c = 0; c < 3; ++c) EXPECT_EQ(view(i, c), label(i, c));
  });
}

TEST(Grid, RefusesTooFewCells) {
  GridShape<2> shape;
  shape.cells = {2, 2};
  EXPECT_THROW(Grid<2>(PETSC_COMM_WORLD, shape), InputError);
}

}  // namespace
}  // namespace washfsi::test
