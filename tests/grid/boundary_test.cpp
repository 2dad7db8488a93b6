// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/boundary.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
GridShape<Dim> box() {
  GridShape<Dim> shape;
  shape.cells.fill(12);
  return shape;
}

// u = A x + b, tangential to no wall in particular: reflection through walls that move with it is exact.
template <int Dim>
void expect_linear_fields_extended() {
  const Grid<Dim> grid(PETSC_COMM_WORLD, box<Dim>());
  typename Boundary<Dim>::Sides sides;
  const auto linear = [](const Point<Dim>& x, double t) {
    Point<Dim> u;
    for (int c = 0; c < Dim; ++c) u[c] = t + x.dot(Point<Dim>::LinSpaced(1.0 + c, 2.5));
    return u;
  };
  for (auto& axis : sides)
    for (auto& side : axis) side.motion = linear;
  const Boundary<Dim> boundary(grid, sides);
  const petsc::Vector velocity = grid.face_vector();
  {
    const FaceView<Dim> u(grid.face_dm(), velocity);
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(grid.owned(),
                    [&](const Index<Dim>& face) { u(face, c) = linear(grid.face_center(face, c), 2.0)[c]; });
  }
  const petsc::LocalVector local(grid.wide_face_dm(), velocity);
  boundary.fill(local, 2.0);
  const ConstFaceView<Dim> u(grid.wide_face_dm(), local);
  for (int c = 0; c < Dim; ++c)
    for_each<Dim>(grid.local(), [&](const Index<Dim>& face) {
      int outside = 0;  // beyond two walls at once the foot of one wall is not on the other: only one at a time
      for (std::size_t d = 0; d < Dim; ++d) outside += (face[d] < 0 || face[d] >= grid.cells()[d]) ? 1 : 0;
      if (outside <= 1) {
        EXPECT_NEAR(u(face, c), linear(grid.face_center(face, c), 2.0)[c], 1e-12);
      }
    });
}

TEST(Boundary, ExtendsLinearFieldsThroughMovingWallsInThePlane) {
  expect_linear_fields_extended<2>();
}
TEST(Boundary, ExtendsLinearFieldsThroughMovingWallsInSpace) {
  expect_linear_fields_extended<3>();
}

// <fill_homogeneous u, f> = <u, fold f>, through the exchange between ranks too.
template <int Dim>
void expect_fold_adjoint_of_fill(bool periodic_in_x) {
  GridShape<Dim> shape = box<Dim>();
  shape.periodic[0] = periodic_in_x;
  const Grid<Dim> grid(PETSC_COMM_WORLD, shape);
  typename Boundary<Dim>::Sides sides;
  sides[1][1].kind = BoundaryKind::slip;
  const Boundary<Dim> boundary(grid, sides);
  const petsc::Vector u = grid.face_vector(), folded = grid.face_vector();
  {
    const FaceView<Dim> view(grid.face_dm(), u);
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(grid.inner_faces(c), [&](const Index<Dim>& i) {
        view(i, c) = std::sin(1.7 * static_cast<double>(std::accumulate(i.begin(), i.end(), PetscInt{c})));
      });
  }
  const petsc::LocalVector filled(grid.wide_face_dm(), u);
  boundary.fill_homogeneous(filled);
  const petsc::LocalVector force(grid.wide_face_dm());
  double left = 0, total = 0;
  {
    const FaceView<Dim> f(grid.wide_face_dm(), force);
    const ConstFaceView<Dim> v(grid.wide_face_dm(), filled);
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(grid.local(), [&](const Index<Dim>& i) {
        f(i, c) = std::cos(0.9 * static_cast<double>(i[0] - 2 * i[1]) + rank_of(grid.comm()) + c);
        left += f(i, c) * v(i, c);
        total += f(i, c);
      });
  }
  const Point<Dim> kept = boundary.fold(force);
  WASH_PETSC(VecZeroEntries(folded));
  WASH_PETSC(DMLocalToGlobal(grid.wide_face_dm(), force, ADD_VALUES, folded));
  double right = 0, remaining = 0;
  WASH_PETSC(VecDot(u, folded, &right));
  WASH_PETSC(VecSum(folded, &remaining));
  EXPECT_NEAR(ordered_sum(grid.comm(), left), right, 1e-11);
  EXPECT_NEAR(ordered_sum(grid.comm(), total), remaining + ordered_sum(grid.comm(), kept.sum()), 1e-10);
}

TEST(Boundary, FoldIsTheAdjointOfFillInThePlane) {
  expect_fold_adjoint_of_fill<2>(false);
  expect_fold_adjoint_of_fill<2>(true);
}
TEST(Boundary, FoldIsTheAdjointOfFillInSpace) {
  expect_fold_adjoint_of_fill<3>(false);
  expect_fold_adjoint_of_fill<3>(true);
}

}  // namespace
}  // namespace washfsi::test
