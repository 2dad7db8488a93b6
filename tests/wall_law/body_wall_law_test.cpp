// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_law/body_wall_law.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "washfsi/fluid/wall_law.hpp"
#include "washfsi/mask/mask.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"

namespace washfsi::test {
namespace {

constexpr PureLiquid water{1000, 1e-3};
constexpr double last_step = 0.01;

/// A half space in the unit box or a sheet across it, and before it water that is sheared along it.
struct ShearedWater {
  double turn = 0;                            ///< of the wall's normal from y, about z [rad]
  Point<3> place = {0.5, 0.37, 0.5};          ///< on the wall [m]
  Point<3> body_velocity = Point<3>::Zero();  ///< along the wall [m/s]
  double shear = 40;                          ///< [1/s]
  double slip = 1;                            ///< on the wall [m/s]
  PetscInt cells = 20;
  BoundaryKind below = BoundaryKind::slip;  ///< the box's lower side
  double moves_from = 0;                    ///< along x; it rests before [m]
  double thickness = 0;                     ///< of a sheet; 0: a half space [cells]
  bool rests_behind = false;                ///< behind the wall

  Point<3> normal() const { return {-std::sin(turn), std::cos(turn), 0}; }
  Point<3> way() const { return {0.6 * std::cos(turn), 0.6 * std::sin(turn), 0.8}; }
  double spacing() const { return 1.0 / static_cast<double>(cells); }
  double speed_at(double cells_off) const { return slip + shear * cells_off * spacing(); }
  /// What the law wants of the stress.
  double expected() const {
    const double distance = 3 * spacing(), nu = water.viscosity / water.density;
    const double friction = wall_distance(speed_at(3) * distance / nu) * nu / distance;
    return water.density * friction * friction;
  }
};

/// The smallest and largest of something.
struct Range {
  double least = std::numeric_limits<double>::max(), most = std::numeric_limits<double>::lowest();

  void take(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  Range of_all_ranks() const { return {-largest(PETSC_COMM_WORLD, -least), largest(PETSC_COMM_WORLD, most)}; }
};

class Case {
 public:
  explicit Case(const ShearedWater& of)
      : flow_(of),
        grid_(PETSC_COMM_WORLD, shape(of)),
        boundary_(grid_, sides(of)),
        mask_(grid_, bodies(of), treatment()),
        markers_(grid_, bodies_, {grid_.spacing(), 1, KernelMoments(DeltaKernel::yang, 2)}),
        law_(grid_, boundary_, bodies_, markers_),
        velocity_(grid_.face_vector()),
        viscosity_(grid_.cell_vector()) {
    const FaceView<3> u(grid_.face_dm(), velocity_);
    for (int c = 0; c < 3; ++c)
      for_each<3>(grid_.owned(), [&](const Index<3>& face) {
        const Point<3> place = grid_.face_center(face, c);
        const double speed = of.slip + of.shear * (place - of.place).dot(of.normal());
        const bool moves = place[0] >= of.moves_from && (!of.rests_behind || (place - of.place).dot(of.normal()) > 0);
        u(face, c) = of.body_velocity[c] + (moves ? speed : 0) * of.way()[c];
      });
    WASH_PETSC(VecSet(viscosity_, water.viscosity));
    law_.observe({velocity_, 0, mask_.fluid_share(), last_step}, water);
    law_.replace(viscosity_);
  }

  double above(const Point<3>& place) const { return (place - flow_.place).dot(flow_.normal()) / flow_.spacing(); }
  bool is_in_the_middle(const Point<3>& place) const {
    return (place - flow_.place - (place - flow_.place).dot(flow_.normal()) * flow_.normal()).norm() < 0.2;
  }

  /// The viscosity of the cells that lie so far before the wall [cells], in the box's middle.
  Range viscosity_between(double nearest, double farthest) const {
    Range range;
    const ConstCellView<3> mu(grid_.cell_dm(), viscosity_);
    for_each<3>(grid_.owned(), [&](const Index<3>& cell) {
      const Point<3> place = grid_.cell_center(cell);
      if (is_in_the_middle(place) && above(place) >= nearest && above(place) <= farthest) range.take(mu(cell));
    });
    return range.of_all_ranks();
  }

  /// The friction on the water per area of the wall, round the box's middle: of all of it, or of that so far before the
  /// wall [cells].
  Point<3> stress(double nearest = -20) const {
    constexpr double width = 0.18;
    const petsc::GlobalVector force(grid_.face_dm());
    WASH_PETSC(VecZeroEntries(force));
    law_.add_friction(force);
    const ConstFaceView<3> f(grid_.face_dm(), force);
    std::vector<double> sums(3, 0.0);
    grid_.for_each_inner_face([&](const Index<3>& face, auto c) {
      const Point<3> arm = grid_.face_center(face, c) - flow_.place;
      if (arm.dot(flow_.normal()) < nearest * flow_.spacing()) return;
      const double across = (arm - arm.dot(flow_.normal()) * flow_.normal()).norm() / width;
      sums[c] += f(face, c) * std::exp(-across * across);
    });
    sums = ordered_sum(PETSC_COMM_WORLD, sums);
    return grid_.cell_volume() / (std::acos(-1) * width * width) * Point<3>(sums.data());
  }

  /// By how much what is held behind the wall slides otherwise than the water does on the wall, of that speed.
  Range inner_slip() const {
    const petsc::GlobalVector slip(grid_.face_dm());
    WASH_PETSC(VecZeroEntries(slip));
    law_.add_inner_slip(mask_.fluid_fraction(), slip);
    const ConstFaceView<3> u(grid_.face_dm(), slip);
    Range range;
    grid_.for_each_inner_face([&](const Index<3>& face, auto c) {
      const Point<3> place = grid_.face_center(face, c);
      if (!is_in_the_middle(place)) return;
      const double expected = above(place) < -2.5 && above(place) > -4.4 ? flow_.slip * flow_.way()[c] : 0;
      if (above(place) > -4.4) range.take((u(face, c) - expected) / flow_.slip);
    });
    return range.of_all_ranks();
  }

  /// By how much the law holds at the patches of markers in a part of the middle along x.
  Range parts_between(double from, double to) const {
    Range range;
    const MarkerPatches<3>& patches = markers_.of_body(0);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const Point<3> place = flow_.place + patches.feet[patches.starts[p]];
      if (is_in_the_middle(place) && place[0] > from && place[0] < to) range.take(law_.patch_slides()[p].part);
    }
    return range;
  }

  Load<3> load() const { return ordered_sum<3>(PETSC_COMM_WORLD, law_.loads_here()).front(); }
  double dissipation() const { return law_.dissipation(velocity_, velocity_, last_step); }
  double largest_y_plus() const { return law_.largest_y_plus().front(); }

 private:
  static BodyTreatment treatment() {
    BodyTreatment treatment{BodyMethod::direct_forcing};
    treatment.inner_water_slides = true;
    return treatment;
  }
  static GridShape<3> shape(const ShearedWater& of) {
    GridShape<3> shape;
    shape.cells.fill(of.cells);
    shape.ghost_width = 3;
    return shape;
  }
  static Boundary<3>::Sides sides(const ShearedWater& of) {
    Boundary<3>::Sides sides;
    for (auto& axis : sides)
      for (auto& side : axis) side.kind = BoundaryKind::slip;
    sides[1][0].kind = of.below;
    return sides;
  }
  const std::vector<Body<3>>& bodies(const ShearedWater& of) {
    bodies_.emplace_back();
    bodies_[0].name = "wall";
    if (of.thickness > 0)
      bodies_[0].shape =
          std::make_unique<Placed<3>>(std::make_unique<Cuboid<3>>(Point<3>(3, of.thickness * of.spacing(), 3)),
                                      Pose<3>::at(Point<3>::Zero(), of.turn));
    else
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

void expect_the_laws_stress(const ShearedWater& flow) {
  const Point<3> stress = Case(flow).stress();
  EXPECT_LT((stress / flow.expected() + flow.way()).norm(), 0.01);
}

TEST(BodyWallLaw, GivesTheLawsStressWhereverAWallLies) {
  for (const double shift : {0.0, 0.25, 0.5}) {
    ShearedWater flow;
    flow.place[1] += shift * flow.spacing();
    expect_the_laws_stress(flow);
  }
}

// What falls on the water inside does not slow that before the wall down.
TEST(BodyWallLaw, GivesItToTheWaterBeforeTheWall) {
  for (const double shift : {0.0, 0.25, 0.5, 0.75}) {
    ShearedWater flow;
    flow.place[1] += shift * flow.spacing();
    const Case seen(flow);
    EXPECT_NEAR(seen.stress(0).norm() / seen.stress().norm(), 1, 0.03) << shift;
  }
}

TEST(BodyWallLaw, GivesItToWallsThatAreTurned) {
  for (const double degrees : {20.0, 45.0}) {
    ShearedWater flow;
    flow.turn = degrees * std::acos(-1) / 180;
    expect_the_laws_stress(flow);
  }
}

TEST(BodyWallLaw, LooksFromTheBody) {
  ShearedWater flow;
  flow.body_velocity = {7, 0, -3};
  expect_the_laws_stress(flow);
}

TEST(BodyWallLaw, LetsInnerWaterSlideAsThatBeforeTheWall) {
  for (const double degrees : {0.0, 20.0}) {
    ShearedWater flow;
    flow.turn = degrees * std::acos(-1) / 180;
    const Range off = Case(flow).inner_slip();
    EXPECT_NEAR(off.least, 0, 1e-9);
    EXPECT_NEAR(off.most, 0, 1e-9);
  }
}

// A side that the deltas reach beyond must not take of it.
TEST(BodyWallLaw, LetsInnerWaterSlideBesideASide) {
  ShearedWater flow;
  flow.place[1] = 0.185;  // 3.7 cells from the side
  flow.below = BoundaryKind::wall;
  const Range off = Case(flow).inner_slip();
  EXPECT_NEAR(off.least, 0, 1e-9);
  EXPECT_NEAR(off.most, 0, 1e-9);
}

TEST(BodyWallLaw, TakesThePowerOfTheWaterOnWhichItActs) {
  const ShearedWater flow;
  const Case seen(flow);
  EXPECT_GT(seen.load().force.norm(), 0.5 * flow.expected());
  EXPECT_NEAR(seen.dissipation() / (seen.load().force.dot(flow.way()) * flow.speed_at(1.5)), 1,
              0.03);  // deltas at slip sides see less
}

TEST(BodyWallLaw, ChangesNothingInLaminarWater) {
  ShearedWater flow;
  flow.shear = 9e-4;  // y+ of 4.5
  flow.slip = 0;
  const Case seen(flow);
  const Range range = seen.viscosity_between(-20, 20);
  EXPECT_EQ(range.least, water.viscosity);
  EXPECT_EQ(range.most, water.viscosity);
  EXPECT_EQ(seen.stress().norm(), 0);
}

TEST(BodyWallLaw, LeavesWaterBeforeTheWallAndKeepsThatInsideCalm) {
  const ShearedWater flow;
  const Case seen(flow);
  EXPECT_EQ(seen.viscosity_between(0, 20).most, water.viscosity);
  const Range inside = seen.viscosity_between(-20, -2);
  EXPECT_NEAR(inside.least * last_step / (water.density * flow.spacing() * flow.spacing()), 0.25, 1e-9);
  EXPECT_EQ(inside.least, inside.most);
}

// Every rank knows of all patches.
TEST(BodyWallLaw, HoldsAtEachPatchByTheWaterBeforeIt) {
  ShearedWater flow;
  flow.moves_from = 0.5;
  const Case seen(flow);
  EXPECT_EQ(seen.parts_between(0.3, 0.4).most, 0);
  EXPECT_EQ(seen.parts_between(0.6, 0.7).least, 1);
}

TEST(BodyWallLaw, RubsBothFacesOfASheet) {
  for (const double shift : {0.0, 0.25, 0.5})
    for (const double degrees : {0.0, 20.0}) {
      ShearedWater flow;
      flow.shear = 0;
      flow.thickness = 0.4;
      flow.turn = degrees * std::acos(-1) / 180;
      flow.place[1] += shift * flow.spacing();
      EXPECT_LT((Case(flow).stress() / flow.expected() + 2 * flow.way()).norm(), 0.02) << shift << ", " << degrees;
    }
}

// It cannot hold the water on one face alone.
TEST(BodyWallLaw, LetsASheetSlideByTheWaterThatPassesFaster) {
  ShearedWater flow;
  flow.shear = 0;
  flow.thickness = 0.4;
  flow.rests_behind = true;
  const Case seen(flow);
  EXPECT_EQ(seen.parts_between(0.3, 0.7).least, 1);
  EXPECT_LT((seen.stress() / flow.expected() + flow.way()).norm(), 0.02);
}

TEST(BodyWallLaw, TellsYPlusOfHalfACell) {
  const ShearedWater flow;
  const double distance = 3 * flow.spacing(), nu = water.viscosity / water.density;
  EXPECT_NEAR(Case(flow).largest_y_plus(), wall_distance(flow.speed_at(3) * distance / nu) / 6, 0.5);
}

/// The area of all points on a body that rests in the unit box.
double area_of(std::unique_ptr<Shape<3>> shape, const Point<3>& center) {
  GridShape<3> box;
  box.cells.fill(20);
  box.ghost_width = 3;
  const Grid<3> grid(PETSC_COMM_WORLD, box);
  std::vector<Body<3>> bodies(1);
  bodies[0].shape = std::move(shape);
  bodies[0].motion.center = center;
  const BodyMarkers<3> markers(grid, bodies, {grid.spacing(), 1, KernelMoments(DeltaKernel::yang, 2)});
  double area = 0;
  for (const auto& point : wall_points<3>(bodies, markers, grid.spacing(), 3)) area += point.area;
  return area;
}

TEST(WallPoints, HaveTheAreaOfTheirSurface) {
  const Point<3> middle(0.51, 0.49, 0.5);
  EXPECT_NEAR(area_of(std::make_unique<Sphere<3>>(0.3), middle) / (4 * std::acos(-1) * 0.09), 1, 0.02);
  EXPECT_NEAR(area_of(std::make_unique<Cuboid<3>>(Point<3>(0.5, 0.4, 0.3)), middle) / 0.94, 1, 0.04);  // less at edges
  EXPECT_NEAR(area_of(std::make_unique<HalfSpace<3>>(Point<3>(0, 1, 0)), middle), 1, 1e-9);
  for (const double cells : {0.1, 0.7, 1.0, 1.3, 2.0})  // thick
    EXPECT_NEAR(area_of(std::make_unique<Cuboid<3>>(Point<3>(3, cells / 20, 3)), middle), 2, 1e-3) << cells;
  EXPECT_NEAR(area_of(std::make_unique<HalfSpace<3>>(Point<3>(-0.6, 0.8, 0)), {0.5, 0.5, 0.5}), 1.25, 0.02);
}

}  // namespace
}  // namespace washfsi::test
