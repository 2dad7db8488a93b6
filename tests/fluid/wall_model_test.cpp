// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/water.hpp"
#include "washfsi/fluid/wall_law.hpp"

namespace washfsi::test {
namespace {

TEST(WallLaw, IsInverted) {
  for (int n = -26; n <= 30; ++n) {
    const double y = std::pow(1.7, n);  // from 1e-6 to 1e7
    EXPECT_NEAR(wall_distance(y * reichardt(y)), y, 1e-10 * y);
  }
  EXPECT_EQ(wall_distance(0), 0);
}

TEST(WallLaw, IsViscousNearAndLogarithmicFar) {
  EXPECT_NEAR(reichardt(0.1) / 0.1, 1, 0.01);
  EXPECT_NEAR(reichardt(2) / 2, 1, 0.03);
  for (const double y : {100.0, 1e3, 1e4}) EXPECT_NEAR(reichardt(y), std::log(y) / 0.41 + 5.6, 0.1);
}

/// A channel whose walls lie across one axis and move with a velocity, and in it a mean flow relative to them along
/// `direction`: Reichardt's law from the nearer wall.
template <int Dim>
struct ChannelCase {
  int axis;
  Point<Dim> direction, walls = Point<Dim>::Zero();  ///< of length 1; [m/s]
  double friction_speed = 0.05, nu = 1e-5, density = 1000, height = 1;

  GridShape<Dim> shape() const {
    GridShape<Dim> shape;
    shape.cells.fill(12);
    shape.cells[static_cast<std::size_t>(axis)] = 20;
    for (int d = 0; d < Dim; ++d) shape.periodic[static_cast<std::size_t>(d)] = d != axis;
    shape.upper[axis] = height;
    return shape;
  }
  typename Boundary<Dim>::Sides sides() const {
    typename Boundary<Dim>::Sides sides;
    for (std::size_t d = 0; d < Dim; ++d)
      for (auto& side : sides[d]) {
        side.kind = static_cast<int>(d) == axis ? BoundaryKind::wall : BoundaryKind::periodic;
        side.velocity = walls;
      }
    return sides;
  }
  double speed(double y) const { return friction_speed * reichardt(std::min(y, height - y) * friction_speed / nu); }
  FluidOptions<Dim> options() const {
    FluidOptions<Dim> options;
    options.density = density;
    options.viscosity = density * nu;
    options.wall_model = WallTreatment::equilibrium;
    options.momentum_tolerance = 1e-12;
    return options;
  }
};

/// Water in a channel.
template <int Dim>
struct ChannelWater {
  explicit ChannelWater(const ChannelCase<Dim>& of)
      : channel(of),
        grid(PETSC_COMM_WORLD, of.shape()),
        boundary(grid, of.sides()),
        water(grid, boundary, of.options()) {
    water.fluid.start([this](const Point<Dim>& x, int c) {
      return channel.walls[c] + channel.direction[c] * channel.speed(x[channel.axis]);
    });
  }
  void update() { water.liquid.update_viscosity({water.fluid.velocity(), 0}); }
  /// Calls visit(stress, component): the discrete friction at each place of the sides [Pa].
  template <class Visit>
  void visit_friction(Visit&& visit) {
    const GhostedVelocity<Dim> local = water.ghosted(grid.face_dm());
    const ConstFaceView<Dim> u(grid.face_dm(), local);
    const CellViscosity<Dim> mu(grid, water.liquid.viscosity());
    const int axis = channel.axis;
    for (const int out : {-1, 1})
      for_each<Dim>(grid.cells_beside(axis, out > 0 ? End::upper : End::lower), [&](const Index<Dim>& cell) {
        for (int c = 0; c < Dim; ++c)
          if (c != axis)
            visit(mu.on_side(cell, c, axis, out) * (u(cell, c) - u(shifted<Dim>(cell, axis, out), c)) /
                      grid.spacing()[axis],
                  c);
      });
  }
  Point<Dim> mean_velocity() const {
    const ConstFaceView<Dim> u(grid.face_dm(), water.fluid.velocity());
    std::vector<double> sums(Dim, 0.0);
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
      for (std::size_t c = 0; c < Dim; ++c) sums[c] += u(cell, static_cast<int>(c));
    });
    sums = ordered_sum(grid.comm(), sums);
    return Point<Dim>(sums.data()) / grid.cell_count();
  }

  ChannelCase<Dim> channel;
  Grid<Dim> grid;
  Boundary<Dim> boundary;
  Water<Dim> water;
};

// y+ of the first cell is 125.
template <int Dim>
void expect_friction_of_the_law(const ChannelCase<Dim>& channel) {
  ChannelWater<Dim> flow(channel);
  flow.update();
  const double stress = channel.density * channel.friction_speed * channel.friction_speed;
  flow.visit_friction([&](double friction, int c) {
    EXPECT_NEAR(friction, stress * channel.direction[c], 1e-6 * stress) << channel.axis;
  });
}

// Whatever way the channel lies, and as seen from one who moves along.
TEST(WallModel, HasTheFrictionOfTheLaw) {
  expect_friction_of_the_law<2>({0, {0, 1}, {0, 0}});
  expect_friction_of_the_law<2>({1, {1, 0}, {0, 0}});
  expect_friction_of_the_law<2>({1, {-1, 0}, {7, 0}});
  expect_friction_of_the_law<3>({0, {0, 0.6, 0.8}, {0, 0, 0}});
  expect_friction_of_the_law<3>({1, {0.6, 0, -0.8}, {0, 0, 0}});
  expect_friction_of_the_law<3>({2, {0.6, 0.8, 0}, {-3, 1, 0}});
}

// The water loses what the walls get.
TEST(WallModel, SlowsTheWaterDown) {
  ChannelWater<3> flow({1, {1, 0, 0}, {2, 0, 0}});
  const double dt = 0.01, before = flow.mean_velocity()[0];
  flow.water.advance(dt);
  const double stress = std::pow(flow.channel.friction_speed, 2);
  EXPECT_NEAR((before - flow.mean_velocity()[0]) / dt, 2 * stress / flow.channel.height, 0.01 * 2 * stress);
}

TEST(WallModel, ChangesNothingWhereTheLayerIsResolved) {
  ChannelCase<3> channel{1, {1, 0, 0}};
  channel.friction_speed = 6e-4;  // y+ 1.5 and 4.5
  ChannelWater<3> flow(channel);
  flow.update();
  Box<3> with_ghosts = flow.grid.owned();
  --with_ghosts.lower[1], ++with_ghosts.upper[1];
  const ConstCellView<3> mu(flow.grid.cell_dm(), flow.water.liquid.viscosity().in_cells);
  for_each<3>(with_ghosts, [&](const Index<3>& cell) { EXPECT_EQ(mu(cell), channel.density * channel.nu); });
}

// Schemes try a step several times.
TEST(WallModel, FiltersOnceAStep) {
  ChannelWater<3> flow({1, {1, 0, 0}});
  flow.water.advance(0.01);
  const auto friction = [&] {
    std::vector<double> all;
    flow.visit_friction([&](double stress, int) { all.push_back(stress); });
    return all;
  };
  Liquid<3>& liquid = flow.water.liquid;
  WASH_PETSC(VecScale(flow.water.fluid.velocity(), 2));
  const StepFlow now{flow.water.fluid.velocity(), 0.01, nullptr, 0.01};
  liquid.update_viscosity(now);
  const auto once = friction();
  liquid.update_viscosity(now);
  EXPECT_EQ(friction(), once);
  liquid.update_viscosity({flow.water.fluid.velocity(), 0.02, nullptr, 0.01});
  const auto later = friction();
  for (std::size_t n = 0; n < once.size(); ++n) EXPECT_TRUE(once[n] == 0 || std::abs(later[n] / once[n] - 1) > 1e-6);
}

TEST(WallModel, TellsTheLargestDistance) {
  ChannelWater<3> flow({1, {0.6, 0, 0.8}, {5, 0, 0}});
  const GhostedVelocity<3> local = flow.water.ghosted(flow.grid.face_dm());
  const double plus =
      largest_y_plus<3>(flow.grid, flow.boundary, {flow.grid.face_dm(), local}, flow.water.liquid.pure());
  EXPECT_NEAR(plus, 0.025 * flow.channel.friction_speed / flow.channel.nu, 1e-6 * plus);
}

}  // namespace
}  // namespace washfsi::test
