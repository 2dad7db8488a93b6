// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/scoped_option.hpp"
#include "support/water.hpp"
#include "washfsi/fluid/transform_preconditioner.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
GridShape<Dim> odd_shape() {
  GridShape<Dim> shape;
  for (std::size_t d = 0; d < Dim; ++d) shape.cells[d] = 13 + 4 * static_cast<PetscInt>(d);
  for (int d = 0; d < Dim; ++d) shape.upper[d] = 1 + 0.5 * d;
  return shape;
}

double wave(double x) {
  return std::sin(12.9898 * x) * 0.5;
}

// One step from a rough state in a box with moving, slipping and fixed sides and an uneven density.
template <int Dim>
void expect_divergence_free(const char* preconditioner) {
  const ScopedOption option("-pressure_pc_type", preconditioner);
  const Grid<Dim> grid(PETSC_COMM_WORLD, odd_shape<Dim>());
  typename Boundary<Dim>::Sides sides;
  sides[1][1].velocity[0] = 1;
  sides[0][0].kind = BoundaryKind::slip;
  Boundary<Dim> boundary(grid, sides);
  Water<Dim> water(grid, boundary);
  const FractionalStep<Dim>& fluid = water.fluid;
  {
    const FaceView<Dim> u(grid.face_dm(), fluid.velocity()), rho(grid.face_dm(), water.liquid.density());
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
      for (int c = 0; c < Dim; ++c) {
        const Point<Dim> x = grid.face_center(cell, c);
        u(cell, c) = wave(x.sum() + c);
        rho(cell, c) = 1000 * (1.2 + wave(3 * x[0] - x[1]));
      }
    });
  }
  boundary.set_boundary_faces(fluid.velocity(), 0);
  water.advance(1e-3);
  const auto flow = FlowDiagnostics<Dim>::of(grid, {water.ghosted(grid.face_dm()), water.liquid.fields()}, 1e-3);
  EXPECT_LT(flow.max_divergence, 1e-6 / grid.spacing().minCoeff()) << (preconditioner ? preconditioner : "default");
  EXPECT_GT(flow.kinetic_energy, 0);
}

TEST(Projection, LeavesNoDivergenceInThePlane) {
  expect_divergence_free<2>(nullptr);
}
TEST(Projection, LeavesNoDivergenceInSpace) {
  expect_divergence_free<3>(nullptr);
}
TEST(Projection, WorksWithBoomerAmg) {
  const ScopedOption type("-pressure_pc_hypre_type", nullptr),
      coarse("-pressure_pc_hypre_boomeramg_relax_type_coarse", nullptr);
  expect_divergence_free<2>("hypre");
  expect_divergence_free<3>("hypre");
}
TEST(Projection, WorksWithMultigrid) {
  // what the solver sets for itself must not reach the next test
  const ScopedOption coarse("-pressure_mg_coarse_pc_type", nullptr),
      dense("-pressure_mg_coarse_redundant_pc_type", nullptr);
  expect_divergence_free<2>("mg");
  expect_divergence_free<3>("mg");
}

TEST(Projection, WorksWithAlgebraicMultigridOfPetsc) {
  const ScopedOption coarse("-pressure_mg_coarse_sub_pc_type", nullptr);
  expect_divergence_free<2>("gamg");
}

template <int Dim>
petsc::Vector rough_right_side(const Grid<Dim>& grid) {
  petsc::Vector rhs = grid.cell_vector();
  const CellView<Dim> r(grid.cell_dm(), rhs);
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) { r(cell) = wave(7 * grid.cell_center(cell).sum()); });
  return rhs;
}

// The fast transforms must invert the uniform operator: one application solves a rough right side, on any mix of sides.
template <int Dim>
void expect_exact_inverse(bool periodic_in_x) {
  GridShape<Dim> shape = odd_shape<Dim>();
  shape.periodic[0] = periodic_in_x;
  const Grid<Dim> grid(PETSC_COMM_WORLD, shape);
  PressureSolver<Dim> poisson(grid);
  const petsc::Vector rhs = rough_right_side(grid), phi = grid.cell_vector();
  double sum = 0;
  WASH_PETSC(VecSum(rhs, &sum));
  WASH_PETSC(VecShift(rhs, -sum / grid.cell_count()));
  EXPECT_EQ(poisson.solve(rhs, 1e-10, phi), 1);
}

TEST(Transform, InvertsTheUniformOperatorInThePlane) {
  expect_exact_inverse<2>(false);
  expect_exact_inverse<2>(true);
}
TEST(Transform, InvertsTheUniformOperatorInSpace) {
  expect_exact_inverse<3>(false);
  expect_exact_inverse<3>(true);
}

// Slabs and pencils do the same sums.
TEST(Transform, SolvesTheSameOnPencils) {
  for (const bool periodic : {false, true}) {
    GridShape<3> shape = odd_shape<3>();
    shape.periodic[1] = periodic;
    const Grid<3> grid(PETSC_COMM_WORLD, shape);
    const petsc::Vector rhs = rough_right_side(grid), by_slabs = grid.cell_vector(), by_pencils = grid.cell_vector();
    TransformSolver<3>(grid).solve(rhs, by_slabs);
    TransformSolver<3>(grid, pencil_layouts(grid.cells(), ranks_of(grid.comm()))).solve(rhs, by_pencils);
    double largest = 0, apart = 0;
    WASH_PETSC(VecNorm(by_slabs, NORM_INFINITY, &largest));
    WASH_PETSC(VecAXPY(by_pencils, -1, by_slabs));
    WASH_PETSC(VecNorm(by_pencils, NORM_INFINITY, &apart));
    EXPECT_GT(largest, 0);
    EXPECT_LT(apart, 1e-13 * largest);
  }
}

// A relative tolerance with a warm start freezes a slow approach to the steady state.
TEST(FractionalStep, ASlowApproachToSteadyStateDoesNotFreeze) {
  GridShape<2> shape;
  shape.cells = {9, 9};
  shape.periodic = {true, false};
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  Boundary<2>::Sides sides;
  sides[0][0].kind = sides[0][1].kind = BoundaryKind::periodic;
  sides[1][1].velocity = {1, 0};
  Boundary<2> boundary(grid, sides);
  FluidOptions<2> options;
  options.density = 1;
  options.viscosity = 0.1;
  Water<2> water(grid, boundary, options);
  for (int n = 0; n < 4000; ++n) water.advance(0.005);  // 2 diffusion times: e^(-20)
  const ConstFaceView<2> u(grid.face_dm(), water.fluid.velocity());
  for_each<2>(grid.owned(), [&](const Index<2>& face) { EXPECT_NEAR(u(face, 0), grid.face_center(face, 0)[1], 1e-6); });
}

TEST(FractionalStep, GivesTheSameFlowForMirroredWalls) {
  // the lid at y = 1 moving right, against the lid at y = 0 moving right: mirror images in y
  std::array<petsc::Vector, 2> velocity;
  GridShape<2> shape;
  shape.cells = {16, 16};
  const Grid<2> grid(PETSC_COMM_SELF, shape);
  for (std::size_t lid = 0; lid < 2; ++lid) {
    Boundary<2>::Sides sides;
    sides[1][lid].velocity = {1, 0};
    Boundary<2> boundary(grid, sides);
    FluidOptions<2> options;
    options.density = 1;
    options.viscosity = 0.01;
    options.momentum_tolerance = options.pressure_tolerance = 1e-13;
    Water<2> water(grid, boundary, options);
    for (int n = 0; n < 20; ++n) water.advance(0.02);
    velocity[lid] = grid.face_vector();
    WASH_PETSC(VecCopy(water.fluid.velocity(), velocity[lid]));
  }
  const ConstFaceView<2> low(grid.face_dm(), velocity[0]), high(grid.face_dm(), velocity[1]);
  for_each<2>(grid.owned(), [&](const Index<2>& face) {
    EXPECT_NEAR(low(face, 0), high({face[0], 15 - face[1]}, 0), 1e-11);
    if (face[1] > 0) {
      EXPECT_NEAR(low(face, 1), -high({face[0], 16 - face[1]}, 1), 1e-11);
    }
  });
}

TEST(Boundary, RefusesANetFlux) {
  const Grid<2> grid(PETSC_COMM_WORLD, odd_shape<2>());
  Boundary<2>::Sides sides;
  sides[0][0].velocity = {1, 0};
  EXPECT_THROW(Boundary<2>(grid, sides), InputError);
}

}  // namespace
}  // namespace washfsi::test
