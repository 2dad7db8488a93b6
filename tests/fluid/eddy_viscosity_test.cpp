// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/eddy_viscosity.hpp"

#include <random>

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "support/water.hpp"
#include "washfsi/fluid/sigma.hpp"
#include "washfsi/fluid/vreman.hpp"
#include "washfsi/fluid/wale.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

const Point<3> flat_cell(0.1, 0.2, 0.04);

// The same on all ranks, without a trace.
Gradient<3> any_gradient(unsigned seed) {
  std::minstd_rand random(seed);
  random.discard(5);
  Gradient<3> g;
  for (int n = 0; n < 9; ++n) g(n / 3, n % 3) = 2.0 * static_cast<double>(random()) / std::minstd_rand::max() - 1;
  return g - g.trace() / 3 * Gradient<3>::Identity();
}

// The laws as their papers write them.
double vreman_by_traces(double c, const Gradient<3>& g) {
  Gradient<3> b = Gradient<3>::Zero();
  for (int m = 0; m < 3; ++m) b += flat_cell[m] * flat_cell[m] * g.col(m) * g.col(m).transpose();
  return c * std::sqrt(0.5 * (b.trace() * b.trace() - (b * b).trace()) / (g.transpose() * g).trace());
}
double sigma_by_svd(double c, const Gradient<3>& g) {
  const Point<3> s = Eigen::JacobiSVD<Gradient<3>>(g).singularValues();
  return std::pow(c * std::cbrt(flat_cell.prod()), 2) * s[2] * (s[0] - s[1]) * (s[1] - s[2]) / (s[0] * s[0]);
}
double wale_by_indices(double c, const Gradient<3>& g) {
  double strain = 0, deviator = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double ij = 0, ji = 0, kk = 0;
      for (int k = 0; k < 3; ++k) {
        ij += g(i, k) * g(k, j);
        ji += g(j, k) * g(k, i);
        for (int l = 0; l < 3; ++l) kk += g(k, l) * g(l, k);
      }
      strain += std::pow(0.5 * (g(i, j) + g(j, i)), 2);
      deviator += std::pow(0.5 * (ij + ji) - (i == j ? kk / 3 : 0), 2);
    }
  return std::pow(c * std::cbrt(flat_cell.prod()), 2) * std::pow(deviator, 1.5) /
         (std::pow(strain, 2.5) + std::pow(deviator, 1.25));
}

TEST(EddyViscosity, IsThatOfThePapers) {
  for (unsigned seed = 1; seed < 50; ++seed) {
    const Gradient<3> g = any_gradient(seed);
    EXPECT_NEAR(Vreman(0.07, flat_cell)(g), vreman_by_traces(0.07, g), 1e-12 * vreman_by_traces(0.07, g));
    EXPECT_NEAR(Wale(0.5, flat_cell)(g), wale_by_indices(0.5, g), 1e-12 * wale_by_indices(0.5, g));
    EXPECT_NEAR(Sigma(1.35, flat_cell)(g), sigma_by_svd(1.35, g), 1e-9 * std::pow(1.35 * flat_cell.maxCoeff(), 2));
  }
}

TEST(EddyViscosity, IsZeroInPureShearAndAtRest) {
  for (int c = 0; c < 3; ++c)
    for (int d = 0; d < 3; ++d) {
      Gradient<3> g = Gradient<3>::Zero();
      if (c != d) g(c, d) = 3;
      EXPECT_EQ(Vreman(0.07, flat_cell)(g), 0);
      EXPECT_EQ(Wale(0.5, flat_cell)(g), 0);
      EXPECT_NEAR(Sigma(1.35, flat_cell)(g), 0, 1e-14);
    }
}

TEST(EddyViscosity, OfSigmaIsZeroInThePlaneAndInRotation) {
  Gradient<3> turning = Gradient<3>::Zero(), plane = any_gradient(3);
  turning << 0, -2, 0.5, 2, 0, -1, -0.5, 1, 0;
  plane.row(2).setZero();
  plane.col(2).setZero();
  const double scale = std::pow(1.35 * flat_cell.maxCoeff(), 2);
  EXPECT_LT(Sigma(1.35, flat_cell)(turning), 1e-7 * scale);
  EXPECT_LT(Sigma(1.35, flat_cell)(plane), 1e-7 * scale);
  // the others are not: what they add within rigid bodies is left out by the bodies' share
  EXPECT_GT(Vreman(0.07, flat_cell)(turning), 1e-5);
  EXPECT_GT(Wale(0.5, flat_cell)(turning), 1e-5);
}

// Water that turns as a whole, seen from any side.
TEST(EddyViscosity, DoesNotDependOnDirections) {
  const Point<3> cube = Point<3>::Constant(0.1), turned_cell(flat_cell[1], flat_cell[2], flat_cell[0]);
  Gradient<3> next = Gradient<3>::Zero();  // x becomes z, y becomes x, z becomes y
  next << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  const Gradient<3> turn = Eigen::AngleAxisd(0.7, Point<3>(1, 2, -0.5).normalized()).toRotationMatrix();
  const auto expect_same = [&](const auto& law, const Gradient<3>& g, const Gradient<3>& r, const auto& turned) {
    EXPECT_NEAR(turned(r * g * r.transpose()), law(g), 1e-9 * std::abs(law(g)) + 1e-14);
  };
  for (unsigned seed = 1; seed < 20; ++seed) {
    const Gradient<3> g = any_gradient(seed);
    expect_same(Vreman(0.07, cube), g, turn, Vreman(0.07, cube));
    expect_same(Sigma(1.35, cube), g, turn, Sigma(1.35, cube));
    expect_same(Wale(0.5, cube), g, turn, Wale(0.5, cube));
    expect_same(Vreman(0.07, flat_cell), g, next, Vreman(0.07, turned_cell));
    expect_same(Sigma(1.35, flat_cell), g, next, Sigma(1.35, turned_cell));
  }
}

// Next to a wall at y = 0, u and w grow with y and v with y^2: WALE and sigma fall with y^3, Vreman with y.
TEST(EddyViscosity, FallsTowardsWalls) {
  const auto near_wall = [](double y) {
    Gradient<3> g;
    g << 0.7 * y, 2, 0.4 * y, 0.3 * y * y, -1.1 * y, 0.5 * y * y, -0.6 * y, 0.9, 0.4 * y;
    return g;
  };
  const auto order = [&](const auto& law) { return std::log2(law(near_wall(2e-2)) / law(near_wall(1e-2))); };
  const Point<3> cube = Point<3>::Ones();
  EXPECT_NEAR(order(Wale(0.5, cube)), 3, 0.1);
  EXPECT_NEAR(order(Sigma(1.35, cube)), 3, 0.1);
  EXPECT_NEAR(order(Vreman(0.07, cube)), 1, 0.1);
}

// A linear velocity between walls that move with it: the same value in every cell, those beside walls too.
template <class Law>
void expect_value_of_linear_flow(double constant) {
  GridShape<3> shape;
  shape.cells = {8, 9, 10};
  for (int d = 0; d < 3; ++d) shape.upper[d] = flat_cell[d] * static_cast<double>(shape.cells[d]);
  const Gradient<3> g = any_gradient(7);
  typename Boundary<3>::Sides sides;
  for (auto& axis : sides)
    for (auto& side : axis) side.motion = [g](const Point<3>& x, double) -> Point<3> { return g * x; };
  const Grid<3> grid(PETSC_COMM_WORLD, shape);
  const Boundary<3> boundary(grid, sides);
  const petsc::Vector velocity = grid.face_vector();
  {
    const FaceView<3> u(grid.face_dm(), velocity);
    for_each<3>(grid.owned(), [&](const Index<3>& cell) {
      for (int c = 0; c < 3; ++c) u(cell, c) = (g * grid.face_center(cell, c))[c];
    });
  }
  Liquid<3> liquid(grid, boundary, {1000, 0.2}, {std::make_shared<EddyViscosity<Law>>(constant)});
  liquid.update_viscosity({velocity, 0});
  const double expected = 1000 * Law(constant, flat_cell)(g);
  EXPECT_GT(expected, 1e-3);
  liquid.visit_added_viscosity([&](double viscosity) { EXPECT_NEAR(viscosity, expected, 1e-8 * expected); });
}

TEST(EddyViscosity, OfALinearFlowIsTheSameInEveryCell) {
  expect_value_of_linear_flow<Vreman>(0.07);
  expect_value_of_linear_flow<Sigma>(1.35);
  expect_value_of_linear_flow<Wale>(0.5);
}

// Half of the viscous force is taken at the step's end with the viscosity of its start, which changes at once from
// cell to cell and step to step: energy falls whatever the step. Constants are large, so that friction decides.
template <class Law>
void expect_energy_to_fall(double constant) {
  GridShape<3> shape;
  shape.cells = {12, 12, 12};
  shape.upper = {1, 1, 0.5};
  shape.periodic = {true, true, true};
  typename Boundary<3>::Sides sides;
  for (auto& axis : sides)
    for (auto& side : axis) side.kind = BoundaryKind::periodic;
  const Grid<3> grid(PETSC_COMM_WORLD, shape);
  Boundary<3> boundary(grid, sides);
  FluidOptions<3> options;
  options.density = 1;
  options.viscosity = 0;
  options.viscosity_models = {std::make_shared<EddyViscosity<Law>>(constant)};
  Water<3> water(grid, boundary, options);
  // rough, and free of divergence: no component changes along its own direction
  water.fluid.start([](const Point<3>& x, int c) { return std::sin(37 * x[(c + 1) % 3] + 51 * x[(c + 2) % 3]); });
  const auto flow = [&] {
    return FlowDiagnostics<3>::of(grid, {water.ghosted(grid.face_dm()), water.liquid.fields()}, 0.002);
  };
  double energy = flow().kinetic_energy, viscous_number = 0;
  const double first = energy;
  for (int step = 0; step < 20; ++step) {
    water.advance(0.002);
    water.liquid.visit_added_viscosity(
        [&](double nu) { viscous_number = std::max(viscous_number, 0.002 * nu * 24 * 24); });
    const double now = flow().kinetic_energy;
    EXPECT_LT(now, energy) << step;
    energy = now;
  }
  EXPECT_GT(largest(grid.comm(), viscous_number), 3);
  EXPECT_LT(energy, 0.5 * first);
}

TEST(EddyViscosity, TakesEnergyOutInEveryStep) {
  expect_energy_to_fall<Vreman>(60);
  expect_energy_to_fall<Sigma>(60);
  expect_energy_to_fall<Wale>(24);
}

// Where solids are, nothing is added.
TEST(EddyViscosity, IsLeftOutInSolids) {
  GridShape<3> shape;
  shape.cells = {12, 12, 12};
  shape.periodic = {true, true, true};
  typename Boundary<3>::Sides sides;
  for (auto& axis : sides)
    for (auto& side : axis) side.kind = BoundaryKind::periodic;
  const Grid<3> grid(PETSC_COMM_WORLD, shape);
  const Boundary<3> boundary(grid, sides);
  const petsc::Vector velocity = grid.face_vector(), share = grid.face_vector();
  {
    const FaceView<3> u(grid.face_dm(), velocity), H(grid.face_dm(), share);
    for_each<3>(grid.owned(), [&](const Index<3>& cell) {
      for (int c = 0; c < 3; ++c) {
        u(cell, c) = std::sin(13.0 * static_cast<double>(cell[0] * (c + 1) + 3 * cell[1] + 5 * cell[2]));
        H(cell, c) = grid.face_center(cell, c)[0] < 0.4 ? 0 : 1;
      }
    });
  }
  Liquid<3> liquid(grid, boundary, {1, 0.2}, {std::make_shared<EddyViscosity<Vreman>>(0.07)});
  liquid.update_viscosity({velocity, 0, share});
  const ConstCellView<3> mu(grid.cell_dm(), liquid.viscosity().in_cells);
  for_each<3>(grid.owned(), [&](const Index<3>& cell) {
    const double x = grid.cell_center(cell)[0];
    if (x < 0.3)
      EXPECT_EQ(mu(cell), 0.2);
    else
      EXPECT_GT(mu(cell), 0.2);
  });
}

}  // namespace
}  // namespace washfsi::test
