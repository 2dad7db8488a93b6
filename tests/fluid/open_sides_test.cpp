// SPDX-License-Identifier: BSD-3-Clause
//
// All kinds of sides at once: mirrored cases give mirrored flows, ranks do not matter, and what flows in flows out.
#include <numbers>

#include <gtest/gtest.h>

#include "support/gather.hpp"
#include "support/water.hpp"
#include "washfsi/grid/stencils.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
using Sides = typename Boundary<Dim>::Sides;

/// A flow between given sides, disturbed at the start, in a box of unequal edges and odd numbers of cells.
template <int Dim>
class DisturbedFlow {
 public:
  /// `mirrored`: the axis along which everything is reflected, or -1.
  DisturbedFlow(MPI_Comm comm, const Sides<Dim>& sides, int mirrored)
      : grid_(comm, shape(sides)), boundary_(grid_, sides), water_(grid_, boundary_, options()) {
    const FaceView<Dim> u(grid_.face_dm(), fluid().velocity());
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(grid_.inner_faces(c), [&](const Index<Dim>& face) {
        Point<Dim> place = grid_.face_center(face, c);
        if (mirrored >= 0) place[mirrored] = grid_.upper()[mirrored] - place[mirrored];
        const Point<Dim> angle = 2 * std::numbers::pi * place.cwiseQuotient(grid_.upper());  // of any periodic side
        u(face, c) = (c == mirrored ? -0.1 : 0.1) * std::sin(angle.sum() + angle[0] + c);
      });
  }

  void run(int steps) {
    for (int n = 0; n < steps; ++n) water_.advance(0.02);
  }

  const Grid<Dim>& grid() const { return grid_; }
  const Boundary<Dim>& boundary() const { return boundary_; }
  const FractionalStep<Dim>& fluid() const { return water_.fluid; }
  double time() const { return water_.clock.time; }
  std::vector<double> velocity(bool everywhere = true) const {
    return gather<Dim, Dim>(grid_, grid_.face_dm(), fluid().velocity(), everywhere);
  }
  std::vector<double> pressure(bool everywhere = true) const {
    return gather<Dim, 1>(grid_, grid_.cell_dm(), fluid().projection().pressure(), everywhere);
  }

 private:
  static GridShape<Dim> shape(const Sides<Dim>& sides) {
    GridShape<Dim> shape;
    for (std::size_t d = 0; d < Dim; ++d) {
      shape.cells[d] = 15 + 2 * static_cast<PetscInt>(d);
      shape.upper[static_cast<int>(d)] = 1 + 0.5 * static_cast<double>(d);
      shape.periodic[d] = sides[d][0].kind == BoundaryKind::periodic;
    }
    return shape;
  }
  static FluidOptions<Dim> options() {
    FluidOptions<Dim> options;
    options.density = 1;
    options.viscosity = 0.01;
    options.momentum_tolerance = 1e-14;
    options.pressure_tolerance = 1e-13;
    return options;
  }

  Grid<Dim> grid_;
  Boundary<Dim> boundary_;
  Water<Dim> water_;
};

template <int Dim>
Sides<Dim> mirrored(Sides<Dim> sides, int axis) {
  for (auto& ends : sides)
    for (auto& side : ends) side.velocity[axis] *= -1;
  std::swap(sides[static_cast<std::size_t>(axis)][0], sides[static_cast<std::size_t>(axis)][1]);
  return sides;
}

template <int Dim>
Side<Dim> side(BoundaryKind kind, double u = 0, double v = 0, InflowProfile profile = InflowProfile::uniform) {
  Side<Dim> side;
  side.kind = kind;
  side.velocity[0] = u;
  side.velocity[1] = v;
  side.profile = profile;
  return side;
}

// Each kind at a lower end at least once.
template <int Dim>
std::vector<Sides<Dim>> cases() {
  using enum BoundaryKind;
  std::vector<Sides<Dim>> all(3);
  all[0][0] = {side<Dim>(inflow, 1, 0.2, InflowProfile::parabolic), side<Dim>(outflow)};
  all[0][1] = {side<Dim>(wall, 0.3, 0), side<Dim>(slip)};
  all[1][0] = {side<Dim>(periodic), side<Dim>(periodic)};
  all[1][1] = {side<Dim>(outflow), side<Dim>(inflow, 0.4, -0.7)};
  all[2][0] = {side<Dim>(outflow), side<Dim>(outflow)};  // two open sides that meet a third
  all[2][1] = {side<Dim>(inflow, 0, 0.5, InflowProfile::parabolic), side<Dim>(outflow)};
  if constexpr (Dim == 3) {
    all[0][2] = {side<Dim>(wall, 0, 0.1), side<Dim>(wall)};
    all[1][2] = {side<Dim>(slip), side<Dim>(wall, -0.2, 0)};
    all[2][2] = {side<Dim>(periodic), side<Dim>(periodic)};
  }
  return all;
}

// The lower face of a cell is the upper face of its mirror image: faces in the lower boundary have no partner.
template <int Dim>
double largest_asymmetry(const DisturbedFlow<Dim>& flow, const DisturbedFlow<Dim>& image, int axis) {
  const std::vector<double> u = flow.velocity(), v = image.velocity(), p = flow.pressure(), q = image.pressure();
  const auto& cells = flow.grid().cells();
  const auto position = [&](const Index<Dim>& cell) {
    std::size_t result = 0;
    for (std::size_t d = Dim; d-- > 0;)
      result = result * static_cast<std::size_t>(cells[d]) + static_cast<std::size_t>(cell[d]);
    return result;
  };
  const auto a = static_cast<std::size_t>(axis);
  double worst = 0;
  for_each<Dim>({{}, cells}, [&](const Index<Dim>& cell) {
    Index<Dim> other = cell;
    other[a] = cells[a] - 1 - cell[a];
    worst = std::max(worst, std::abs(p[position(cell)] - q[position(other)]));
    for (int c = 0; c < Dim; ++c) {
      if (c == axis && cell[a] == 0) continue;
      const Index<Dim> partner = c == axis ? shifted<Dim>(other, axis, 1) : other;
      const auto k = static_cast<std::size_t>(c);
      worst = std::max(worst,
                       std::abs(u[Dim * position(cell) + k] - (c == axis ? -1 : 1) * v[Dim * position(partner) + k]));
    }
  });
  return worst;
}

template <int Dim>
void expect_mirrored_flows() {
  for (const Sides<Dim>& sides : cases<Dim>()) {
    DisturbedFlow<Dim> flow(PETSC_COMM_WORLD, sides, -1);
    flow.run(5);
    for (int axis = 0; axis < Dim; ++axis) {
      DisturbedFlow<Dim> image(PETSC_COMM_WORLD, mirrored<Dim>(sides, axis), axis);
      image.run(5);
      EXPECT_LT(largest_asymmetry<Dim>(flow, image, axis), 1e-11) << "axis " << axis;
    }
  }
}

TEST(OpenSides, LowAndHighSidesMirrorEachOtherInThePlane) {
  expect_mirrored_flows<2>();
}
TEST(OpenSides, LowAndHighSidesMirrorEachOtherInSpace) {
  expect_mirrored_flows<3>();
}

template <int Dim>
void expect_same_on_one_rank() {
  for (const Sides<Dim>& sides : cases<Dim>()) {
    DisturbedFlow<Dim> together(PETSC_COMM_WORLD, sides, -1), alone(PETSC_COMM_SELF, sides, -1);
    together.run(5);
    alone.run(5);
    const std::vector<double> u = together.velocity(), v = alone.velocity(false);
    const std::vector<double> p = together.pressure(), q = alone.pressure(false);
    double worst = 0;
    for (std::size_t i = 0; i < u.size(); ++i) worst = std::max(worst, std::abs(u[i] - v[i]));
    for (std::size_t i = 0; i < p.size(); ++i) worst = std::max(worst, std::abs(p[i] - q[i]));
    EXPECT_LT(worst, 1e-11);
  }
}

TEST(OpenSides, RanksDoNotMatterInThePlane) {
  expect_same_on_one_rank<2>();
}
TEST(OpenSides, RanksDoNotMatterInSpace) {
  expect_same_on_one_rank<3>();
}

// Divergence telescopes: its sum over all cells is what leaves the box.
TEST(OpenSides, WhatFlowsInFlowsOut) {
  for (const Sides<3>& sides : cases<3>()) {
    DisturbedFlow<3> flow(PETSC_COMM_WORLD, sides, -1);
    for (int n = 0; n < 4; ++n) {
      flow.run(1);
      const petsc::LocalVector local(flow.grid().face_dm(), flow.fluid().velocity());
      flow.boundary().fill(local, flow.time());
      const ConstFaceView<3> u(flow.grid().face_dm(), local);
      const Spacing<3> h(flow.grid().spacing());
      double sum = 0;
      for_each<3>(flow.grid().owned(), [&](const Index<3>& cell) { sum += divergence<3>(u, cell, h); });
      EXPECT_LT(std::abs(ordered_sum(PETSC_COMM_WORLD, sum) * flow.grid().cell_volume()), 1e-13);
    }
  }
}

TEST(OpenSides, NetFluxWithoutOutflowIsRefused) {
  Sides<2> sides;
  sides[0][0] = side<2>(BoundaryKind::inflow, 1, 0, InflowProfile::parabolic);
  EXPECT_THROW(DisturbedFlow<2>(PETSC_COMM_WORLD, sides, -1), InputError);
  sides[0][1] = side<2>(BoundaryKind::inflow, 1, 0, InflowProfile::parabolic);  // what enters left leaves right
  EXPECT_NO_THROW(DisturbedFlow<2>(PETSC_COMM_WORLD, sides, -1));
}

// A channel that a parabolic inflow feeds: Poiseuille's flow everywhere, exact but for the walls' reflection, whose
// error is h^2/4 of the parabola's curvature.
TEST(OpenSides, ParabolicInflowBecomesPoiseuilleFlow) {
  GridShape<2> shape;
  shape.cells = {24, 16};
  shape.upper = {3, 1};
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  Sides<2> sides;
  sides[0] = {side<2>(BoundaryKind::inflow, 1, 0, InflowProfile::parabolic), side<2>(BoundaryKind::outflow)};
  Boundary<2> boundary(grid, sides);
  FluidOptions<2> options;
  options.density = 1;
  options.viscosity = 0.1;
  Water<2> water(grid, boundary, options);
  for (int n = 0; n < 500; ++n) water.advance(0.02);
  const ConstFaceView<2> u(grid.face_dm(), water.fluid.velocity());
  const ConstCellView<2> p(grid.cell_dm(), water.fluid.projection().pressure());
  const double h = grid.spacing()[1];
  for_each<2>(grid.owned(), [&](const Index<2>& cell) {
    const double y = grid.face_center(cell, 0)[1];
    EXPECT_NEAR(u(cell, 0), 4 * y * (1 - y), 1.05 * h * h);
    EXPECT_NEAR(u(cell, 1), 0, 0.5 * h * h);
    if (grid.owned().contains(shifted<2>(cell, 0, 1)) && cell[0] > 12) {
      const double slope = (p(shifted<2>(cell, 0, 1)) - p(cell)) / grid.spacing()[0];
      EXPECT_NEAR(slope, -8 * options.viscosity, 0.01 * 8 * options.viscosity);
    }
  });
}

// A vortex is carried out through the open side. What is left then is what the side has reflected.
TEST(OpenSides, VortexLeavesThroughAnOutflow) {
  GridShape<2> shape;
  shape.cells = {64, 32};
  shape.upper = {2, 1};
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  using enum BoundaryKind;
  Sides<2> sides;
  sides[0] = {side<2>(inflow, 1, 0), side<2>(outflow)};
  sides[1] = {side<2>(slip), side<2>(slip)};
  Boundary<2> boundary(grid, sides);
  FluidOptions<2> options;
  options.density = 1;
  options.viscosity = 1e-4;
  Water<2> water(grid, boundary, options);
  FractionalStep<2>& fluid = water.fluid;
  fluid.start([](const Point<2>&, int c) { return c == 0 ? 1 : 0; });
  {
    const FaceView<2> u(grid.face_dm(), fluid.velocity());
    for (int c = 0; c < 2; ++c)
      for_each<2>(grid.inner_faces(c), [&](const Index<2>& face) {
        const Point<2> arm = (grid.face_center(face, c) - Point<2>(1.2, 0.5)) / 0.1;
        u(face, c) += 0.5 * std::exp(0.5 - 0.5 * arm.squaredNorm()) * (c == 0 ? -arm[1] : arm[0]);
      });
  }
  const auto disturbance = [&] {
    const ConstFaceView<2> u(grid.face_dm(), fluid.velocity());
    double energy = 0;
    for_each<2>(grid.owned(),
                [&](const Index<2>& cell) { energy += std::pow(u(cell, 0) - 1, 2) + std::pow(u(cell, 1), 2); });
    return ordered_sum(grid.comm(), energy);
  };
  const double before = disturbance();
  for (int n = 0; n < 200; ++n) water.advance(0.01);
  const double left = disturbance() / before;
  EXPECT_LT(left, 0.01);
  if (rank_of(grid.comm()) == 0) std::printf("energy of the disturbance left by the vortex: %.2e\n", left);
}

}  // namespace
}  // namespace washfsi::test
