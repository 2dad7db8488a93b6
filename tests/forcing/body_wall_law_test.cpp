// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/body_wall_law.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "washfsi/body/mask.hpp"
#include "washfsi/body/primitives.hpp"
#include "washfsi/fluid/wall_law.hpp"

namespace washfsi::test {
namespace {

constexpr PureLiquid water{1000, 1e-3};
constexpr double last_step = 0.01;

/// A half space in the unit box, and before it water that is sheared along it, at rest on it.
struct ShearedWater {
  double turn = 0;                            ///< of the wall's normal from y, about z [rad]
  Point<3> place = {0.5, 0.37, 0.5};          ///< on the wall [m]
  Point<3> body_velocity = Point<3>::Zero();  ///< along the wall [m/s]
  double shear = 40;                          ///< [1/s]
  PetscInt cells = 20;

  Point<3> normal() const { return {-std::sin(turn), std::cos(turn), 0}; }
  Point<3> way() const { return {0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.8}; }
  double spacing() const { return 1.0 / static_cast<double>(cells); }
  /// What the law wants of the viscosity where the shear is so.
  double expected() const {
    const double distance = 2.5 * spacing(), nu = water.viscosity / water.density;
    const double friction = wall_distance(shear * distance * distance / nu) * nu / distance;
    return water.density * friction * friction / shear;
  }
};

/// The viscosity that the law gives a cell at a distance [cells] from the wall, smallest and largest in the box's
/// middle.
struct Range {
  double least = std::numeric_limits<double>::max(), most = 0;
};

class Case {
 public:
  explicit Case(const ShearedWater& of)
      : flow_(of),
        grid_(PETSC_COMM_WORLD, shape(of)),
        boundary_(grid_, sides()),
        mask_(grid_, bodies(of), {BodyMethod::direct_forcing}),
        markers_(grid_, bodies_, {grid_.spacing(), 1, KernelMoments(DeltaKernel::yang, 2)}),
        law_(grid_, boundary_, bodies_, markers_),
        velocity_(grid_.face_vector()),
        viscosity_(grid_.cell_vector()) {
    const FaceView<3> u(grid_.face_dm(), velocity_);
    for (int c = 0; c < 3; ++c)
      for_each<3>(grid_.owned(), [&](const Index<3>& face) {
        const double above = (grid_.face_center(face, c) - of.place).dot(of.normal());
        u(face, c) = of.body_velocity[c] + of.shear * above * of.way()[c];
      });
    WASH_PETSC(VecSet(viscosity_, water.viscosity));
    law_.observe({velocity_, 0, mask_.fluid_share(), last_step}, water);
    law_.replace(viscosity_);
  }

  Range between(double nearest, double farthest) const {
    Range range;
    const ConstCellView<3> mu(grid_.cell_dm(), viscosity_);
    for_each<3>(grid_.owned(), [&](const Index<3>& cell) {
      const Point<3> from_middle = grid_.cell_center(cell) - Point<3>::Constant(0.5);
      const double above = (grid_.cell_center(cell) - flow_.place).dot(flow_.normal()) / flow_.spacing();
      if (from_middle[0] * from_middle[0] + from_middle[2] * from_middle[2] > 0.04 || above < nearest ||
          above > farthest)
        return;
      range.least = std::min(range.least, mu(cell));
      range.most = std::max(range.most, mu(cell));
    });
    return {-largest(PETSC_COMM_WORLD, -range.least), largest(PETSC_COMM_WORLD, range.most)};
  }
  double largest_y_plus() const { return law_.largest_y_plus().front(); }

 private:
  static GridShape<3> shape(const ShearedWater& of) {
    GridShape<3> shape;
    shape.cells.fill(of.cells);
    shape.ghost_width = 3;
    return shape;
  }
  static Boundary<3>::Sides sides() {
    Boundary<3>::Sides sides;
    for (auto& axis : sides)
      for (auto& side : axis) side.kind = BoundaryKind::slip;
    return sides;
  }
  const std::vector<Body<3>>& bodies(const ShearedWater& of) {
    bodies_.emplace_back();
    bodies_[0].name = "wall";
    bodies_[0].shape = std::make_unique<HalfSpace<3>>(of.normal());
    bodies_[0].motion.center = of.place;
    bodies_[0].motion.translation = of.body_velocity;
    return bodies_;
  }

  ShearedWater flow_;
  Grid<3> grid_;
  Boundary<3> boundary_;
  std::vector<Body<3>> bodies_;
  Mask<3> mask_;
  BodyMarkers<3> markers_;
  BodyWallLaw<3> law_;
  petsc::Vector velocity_, viscosity_;
};

// The whole of the law's stress, as the sheared water has no eddies.
void expect_the_laws_stress(const ShearedWater& flow, double tolerance) {
  const Range range = Case(flow).between(0.3, 1.7);
  EXPECT_NEAR(range.least / flow.expected(), 1, tolerance);
  EXPECT_NEAR(range.most / flow.expected(), 1, tolerance);
}

TEST(BodyWallLaw, GivesTheLawsStressWhereverAWallLies) {
  for (const double shift : {0.0, 0.25, 0.5}) {
    ShearedWater flow;
    flow.place[1] += shift * flow.spacing();
    expect_the_laws_stress(flow, 1e-6);
  }
}

TEST(BodyWallLaw, GivesItToWallsThatAreTurned) {
  for (const double degrees : {20.0, 45.0}) {
    ShearedWater flow;
    flow.turn = degrees * std::acos(-1) / 180;
    expect_the_laws_stress(flow, 0.02);
  }
}

TEST(BodyWallLaw, LooksFromTheBody) {
  ShearedWater flow;
  flow.body_velocity = {7, 0, -3};
  expect_the_laws_stress(flow, 1e-6);
}

TEST(BodyWallLaw, ChangesNothingInLaminarWater) {
  ShearedWater flow;
  flow.shear = 1.4e-3;  // y+ of 4.7
  const Range range = Case(flow).between(-20, 20);
  EXPECT_EQ(range.least, water.viscosity);
  EXPECT_EQ(range.most, water.viscosity);
}

TEST(BodyWallLaw, LeavesWaterFarOffAndKeepsThatInsideAtRest) {
  const ShearedWater flow;
  const Case seen(flow);
  EXPECT_EQ(seen.between(3.6, 20).most, water.viscosity);
  const Range inside = seen.between(-20, -2);
  EXPECT_NEAR(inside.least * last_step / (water.density * flow.spacing() * flow.spacing()), 0.25, 1e-9);
  EXPECT_EQ(inside.least, inside.most);
}

TEST(BodyWallLaw, TellsYPlusOfHalfACell) {
  const ShearedWater flow;
  const double distance = 2.5 * flow.spacing(), nu = water.viscosity / water.density;
  EXPECT_NEAR(Case(flow).largest_y_plus(), 0.2 * wall_distance(flow.shear * distance * distance / nu), 0.5);
}

}  // namespace
}  // namespace washfsi::test
