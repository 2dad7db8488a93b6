// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/wall_loads.hpp"

#include <gtest/gtest.h>

#include "washfsi/mask/mask_loads.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"

namespace washfsi::test {
namespace {

constexpr double channel_viscosity = 0.3, channel_height = 1, channel_length = 2;

GridShape<2> channel() {
  GridShape<2> shape;
  shape.cells = {16, 12};
  shape.upper = {channel_length, channel_height};
  return shape;
}

/// Flow between plates: the parabola that solves the discrete equations, with p = -2 mu x.
double parabola(double y, double spacing) {
  return y * (1 - y) + spacing * spacing / 4;
}

TEST(WallLoads, OfAChannelBalanceItsPressureDrop) {
  const Grid<2> grid(PETSC_COMM_WORLD, channel());
  Boundary<2>::Sides sides_of_box;
  for (auto& end : sides_of_box[0])
    end.motion = [h = grid.spacing()[1]](const Point<2>& place, double) { return Point<2>(parabola(place[1], h), 0); };
  const Boundary<2> boundary(grid, sides_of_box);
  const petsc::Vector velocity = grid.face_vector(), pressure = grid.cell_vector();
  {
    const FaceView<2> u(grid.face_dm(), velocity);
    const CellView<2> p(grid.cell_dm(), pressure);
    for_each<2>(grid.owned(), [&](const Index<2>& cell) {
      u(cell, 0) = parabola(grid.face_center(cell, 0)[1], grid.spacing()[1]);
      p(cell) = -2 * channel_viscosity * grid.cell_center(cell)[0];
    });
  }
  const auto sides = exposed_walls<2>(grid, boundary, {});
  ASSERT_EQ(sides.size(), 4U);
  const GhostedVelocity<2> local_velocity(boundary, grid.face_dm(), velocity, 0);
  const auto loads = wall_loads<2>(grid, boundary, {}, sides, local_velocity, pressure, {channel_viscosity}, 0);
  const double drop = 2 * channel_viscosity * channel_length, friction = channel_viscosity * channel_length;
  EXPECT_NEAR(loads[0].force[0], 0, 1e-12);                       // x lower, where p = 0
  EXPECT_NEAR(loads[1].force[0], -drop * channel_height, 1e-12);  // x upper
  EXPECT_NEAR(loads[2].force[0], friction, 1e-12);                // y lower
  EXPECT_NEAR(loads[3].force[0], friction, 1e-12);                // y upper
  EXPECT_NEAR(loads[2].torque[0] + loads[3].torque[0], 0, 1e-12);
  EXPECT_NEAR(loads[2].force[1] + loads[3].force[1], 0, 1e-12);
}

TEST(WallLoads, LeaveOutWhatABodyCovers) {
  std::vector<Body<2>> bodies(1);
  bodies[0].name = "drum";
  bodies[0].shape = std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(0.45));
  bodies[0].motion.center = {channel_length / 2, channel_height / 2};
  const Grid<2> grid(PETSC_COMM_WORLD, channel());
  const Boundary<2> boundary(grid, {});
  EXPECT_TRUE(exposed_walls<2>(grid, boundary, bodies).empty());
  bodies[0].motion.angular_speed = 3;
  EXPECT_TRUE(exposed_walls<2>(grid, boundary, bodies).empty());
}

TEST(WallLoads, AreThereWhereATurningBodyCoversASideOnlyAtTimes) {
  std::vector<Body<2>> bodies(1);
  bodies[0].shape = std::make_unique<Inverted<2>>(std::make_unique<Cuboid<2>>(Point<2>(1.7, 0.5)));
  bodies[0].motion.center = {channel_length / 2, channel_height / 2};
  const Grid<2> grid(PETSC_COMM_WORLD, channel());
  const Boundary<2> boundary(grid, {});
  EXPECT_TRUE(exposed_walls<2>(grid, boundary, bodies).empty());
  bodies[0].motion.angular_speed = 3;
  EXPECT_EQ(exposed_walls<2>(grid, boundary, bodies).size(), 2U);  // those along x
  bodies[0].motion.translation = {1, 0};
  EXPECT_EQ(exposed_walls<2>(grid, boundary, bodies).size(), 4U);
}

TEST(WallLoads, OfTheWaterBesideABodyAreNotTheBodys) {
  std::vector<Body<2>> bodies(1);
  bodies[0].name = "foot";
  bodies[0].shape = std::make_unique<Sphere<2>>(0.33);
  bodies[0].motion.center = {channel_length / 2, 0};  // half of it beneath the floor
  const Grid<2> grid(PETSC_COMM_WORLD, channel());
  const Boundary<2> boundary(grid, {});
  Mask<2> mask(grid, bodies, {.method = BodyMethod::cut_stencil});
  mask.update(0);
  const petsc::Vector velocity = grid.face_vector();
  WASH_PETSC(VecSet(velocity, 1));
  mask.apply(velocity);
  const GhostedVelocity<2> local_velocity(boundary, grid.face_dm(), velocity, 0);
  const auto loads = hidden_wall_shear(mask, boundary, local_velocity, {channel_viscosity}, 0);
  EXPECT_NEAR(loads[0].force[0], 0, 1e-12);
}

}  // namespace
}  // namespace washfsi::test
