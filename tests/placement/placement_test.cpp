// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/placement/placement.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "washfsi/motion/repeat_bodies.hpp"
#include "washfsi/placement/plate_mode.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/vaned.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

std::vector<Body<2>> washtub() {
  std::vector<Body<2>> bodies(2);
  bodies[0].name = "drum";
  bodies[0].shape = std::make_unique<Inverted<2>>(std::make_unique<Sphere<2>>(0.3186));
  bodies[1].name = "agitator";
  bodies[1].shape = vaned({.tip_radius = 0.191});
  return bodies;
}

ClothGroup<2> group(const std::string& name, PetscInt count, double size, PetscInt markers) {
  ClothGroup<2> result;
  result.name = name;
  result.count = count;
  result.size = {size, 1};
  result.markers = {markers, 1};
  result.sheet.ds = size / static_cast<double>(markers);
  return result;
}

PlacementOptions<2> placed(PlacementRule rule, PetscInt seed = 1) {
  PlacementOptions<2> options;
  options.rule = rule;
  options.radius = 0.3186;
  options.clearance = 0.012;
  options.seed = seed;
  return options;
}

const PeriodicSpace<2> space{Point<2>::Constant(-0.3456), Point<2>::Constant(0.6912), {}};

TEST(RandomPlacement, KeepsClearOfBodiesAndOfEachOther) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("long", 10, 0.2592, 24), group("short", 10, 0.1728, 16)});
  const std::vector<Body<2>> bodies = washtub();
  const Points<2> places =
      place_cloths<2>(cloths, {placed(PlacementRule::random), placed(PlacementRule::random, 2)}, bodies, space);
  ASSERT_EQ(places.size(), 400U);
  for (const auto& place : places) EXPECT_GE(nearest_distance<2>(bodies, place, 0), 0.012 - 1e-12);
  for (const Piece& a : cloths.pieces())
    for (const Piece& b : cloths.pieces()) {
      if (a.first >= b.first) continue;
      double nearest = 1;
      for (PetscInt i = a.first; i < a.first + a.count; ++i)
        for (PetscInt j = b.first; j < b.first + b.count; ++j)
          nearest =
              std::min(nearest, (places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)]).norm());
      EXPECT_GE(nearest, 0.012 - 1e-12);
    }
}

// A post on the left side, which is the right one too, between cloths that may lie across it.
TEST(RandomPlacement, KeepsClearOfImagesBehindPeriodicSides) {
  const Grid<2> grid(PETSC_COMM_WORLD,
                     {.cells = {32, 32}, .lower = space.lower, .upper = -space.lower, .periodic = {true, true}});
  std::vector<Body<2>> post(1);
  post[0].name = "post";
  post[0].shape = std::make_unique<Sphere<2>>(0.1);
  post[0].motion.center = {-0.3456, 0.02};
  const std::vector<Body<2>> bodies = repeat_bodies<2>(grid, std::move(post));
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("towel", 12, 0.2592, 24)});
  PlacementOptions<2> options = placed(PlacementRule::random);
  options.radius = 0.6;
  const Points<2> places = place_cloths<2>(cloths, {options}, bodies, periods_of<2>(grid));
  const auto images_apart = [](Point<2> apart) {
    for (int d = 0; d < 2; ++d) apart[d] -= 0.6912 * std::round(apart[d] / 0.6912);
    return apart.norm();
  };
  bool any_beyond = false;
  for (std::size_t m = 0; m < places.size(); ++m) {
    any_beyond = any_beyond || places[m].cwiseAbs().maxCoeff() > 0.3456;
    EXPECT_GE(images_apart(places[m] - bodies[0].motion.center), 0.112 - 1e-12);
    for (std::size_t other = 24 * (m / 24 + 1); other < places.size(); ++other)
      EXPECT_GE(images_apart(places[m] - places[other]), 0.012 - 1e-12);
  }
  EXPECT_TRUE(any_beyond);
}

TEST(RandomPlacement, DependsOnTheSeedOnly) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("towel", 5, 0.2, 10)});
  const std::vector<Body<2>> bodies = washtub();
  const Points<2> first = place_cloths<2>(cloths, {placed(PlacementRule::random, 7)}, bodies, space);
  EXPECT_EQ(first, place_cloths<2>(cloths, {placed(PlacementRule::random, 7)}, bodies, space));
  EXPECT_NE(first, place_cloths<2>(cloths, {placed(PlacementRule::random, 8)}, bodies, space));
}

TEST(Placement, StartsAllClothsUnstretched) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("towel", 4, 0.08, 8)});
  for (const PlacementRule rule :
       {PlacementRule::line, PlacementRule::stack, PlacementRule::radial, PlacementRule::random}) {
    PlacementOptions<2> options = placed(rule);
    options.center =
        rule == PlacementRule::radial || rule == PlacementRule::random ? Point<2>(0, 0) : Point<2>(-0.15, 0);
    const Points<2> places = place_cloths<2>(cloths, {options}, {}, space);
    for (std::size_t k = 1; k < 8; ++k) EXPECT_NEAR((places[k] - places[k - 1]).norm(), 0.01, 1e-15) << name_of(rule);
  }
}

TEST(Placement, RefusesClothInASolid) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("towel", 1, 0.2, 10)});
  EXPECT_THROW((void)place_cloths<2>(cloths, {placed(PlacementRule::line)}, washtub(), space), InputError);
}

TEST(RandomPlacement, SaysSoWhenThereIsNoRoom) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("carpet", 1, 0.7, 10)});
  EXPECT_THROW((void)place_cloths<2>(cloths, {placed(PlacementRule::random)}, washtub(), space), InputError);
}

FlatCloth<3> rectangle(const Point<3>& middle, const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity()) {
  return {axes, middle, {0.1, 0.05}};
}

TEST(FlatCloths, DistanceOfRectanglesInSpace) {
  const FlatCloth<3> cloth = rectangle({0, 0, 0});
  EXPECT_NEAR(distance(cloth, rectangle({0.05, 0.02, 0.3})), 0.3, 1e-12);                    // above each other
  EXPECT_NEAR(distance(cloth, rectangle({0.5, 0, 0})), 0.3, 1e-12);                          // side by side
  EXPECT_NEAR(distance(cloth, rectangle({0.23, 0.14, 0})), 0.05, 1e-12);                     // corner to corner
  EXPECT_NEAR(distance(cloth, rectangle({5, 0, 0})), 5 - 2 * std::hypot(0.1, 0.05), 1e-12);  // far: a lower bound
  Eigen::Matrix3d standing;
  standing.col(0) = Point<3>::UnitZ();
  standing.col(1) = Point<3>::UnitX();
  standing.col(2) = Point<3>::UnitY();
  EXPECT_NEAR(distance(cloth, rectangle({0, 0, 0.05}, standing)), 0, 1e-12);  // through each other
  EXPECT_NEAR(distance(cloth, rectangle({0, 0, 0.2}, standing)), 0.1, 1e-12);
  EXPECT_NEAR(distance(rectangle({0, 0, 0.2}, standing), cloth), 0.1, 1e-12);
}

TEST(FlatCloths, DistanceOfSegmentsInThePlane) {
  const FlatCloth<2> segment{Eigen::Matrix2d::Identity(), {0, 0}, FlatCloth<2>::Coordinates(0.1)};
  Eigen::Matrix2d upright;
  upright << 0, -1, 1, 0;
  EXPECT_NEAR(distance(segment, {upright, {0.05, 0.05}, FlatCloth<2>::Coordinates(0.1)}), 0, 1e-12);
  EXPECT_NEAR(distance(segment, {upright, {0.15, 0.05}, FlatCloth<2>::Coordinates(0.1)}), 0.05, 1e-12);
}

ClothGroup<3> towels(PetscInt count) {
  ClothGroup<3> result;
  result.name = "towel";
  result.count = count;
  result.size = {0.15, 0.12};
  result.markers = {6, 5};
  result.sheet = {.width = 5, .ds = 0.025, .dr = 0.024};
  return result;
}

const PeriodicSpace<3> tub_space{Point<3>(-0.36, -0.36, 0), Point<3>(0.72, 0.72, 0.24), {}};

PlacementOptions<3> in_the_tub(PlacementRule rule, double height) {
  PlacementOptions<3> options;
  options.rule = rule;
  options.center = {0, 0, height};
  return options;
}

TEST(Placement, StartsSheetsUnstretched) {
  const Cloths<3> cloths(PETSC_COMM_WORLD, {towels(4)});
  for (const PlacementRule rule :
       {PlacementRule::line, PlacementRule::stack, PlacementRule::radial, PlacementRule::random}) {
    PlacementOptions<3> options = in_the_tub(rule, 0.1);
    options.shift = 0.003;
    options.tilt = 0.05;
    options.distance = 0.01;
    if (options.rule == PlacementRule::line) options.center[0] = -0.25;
    const Points<3> places = place_cloths<3>(cloths, {options}, {}, tub_space);
    ASSERT_EQ(places.size(), 120U);
    for (std::size_t k = 0; k < 30; ++k) {
      if (k % 5 > 0) {
        EXPECT_NEAR((places[k] - places[k - 1]).norm(), 0.024, 1e-14) << name_of(rule);
      }
      if (k >= 5) {
        EXPECT_NEAR((places[k] - places[k - 5]).norm(), 0.025, 1e-14) << name_of(rule);
      }
    }
  }
}

// The edges of a cloth are where they are whatever its markers.
TEST(Placement, LaysCornersOfNodalLatticesOnTheEdges) {
  ClothGroup<3> cloth = towels(1);
  cloth.sheet.lattice = MarkerLattice::nodal;
  const Cloths<3> cloths(PETSC_COMM_WORLD, {cloth});
  const Points<3> places = place_cloths<3>(cloths, {in_the_tub(PlacementRule::line, 0.1)}, {}, tub_space);
  for (const std::size_t k : {0U, 4U, 25U, 29U})
    EXPECT_LE((places[k] - Point<3>(k < 25 ? -0.075 : 0.075, k % 5 == 0 ? -0.06 : 0.06, 0.1)).norm(), 1e-16) << k;
}

TEST(Placement, RefiningANodalFibreKeepsItsNodes) {
  const auto places_of = [](PetscInt markers) {
    ClothGroup<2> fibre = group("towel", 1, 0.3, markers);
    fibre.sheet.lattice = MarkerLattice::nodal;
    fibre.shape = ClothShape::mode;
    PlacementOptions<2> options = placed(PlacementRule::line);
    options.direction = {1, 2};
    return place_cloths<2>(Cloths<2>(PETSC_COMM_WORLD, {fibre}), {options}, {}, space);
  };
  const Points<2> coarse = places_of(9), fine = places_of(17);
  for (std::size_t k = 0; k < 9; ++k) EXPECT_LE((coarse[k] - fine[2 * k]).norm(), 1e-16) << k;
}

TEST(RadialPlacement, StandsFinsRoundThePost) {
  const Cloths<3> cloths(PETSC_COMM_WORLD, {towels(8)});
  PlacementOptions<3> options = in_the_tub(PlacementRule::radial, 0.1);
  options.inner_radius = 0.1;
  const Points<3> places = place_cloths<3>(cloths, {options}, {}, tub_space);
  for (std::size_t cloth = 0; cloth < 8; ++cloth) {
    const Point<3> first = places[30 * cloth], out = places[30 * cloth + 25], up = places[30 * cloth + 4];
    EXPECT_NEAR(first.head<2>().norm(), 0.1 + 0.0125, 1e-12);
    EXPECT_NEAR(out.head<2>().norm(), 0.25 - 0.0125, 1e-12);
    EXPECT_NEAR((up - first)[2], 0.12 - 0.024, 1e-12);
    EXPECT_NEAR((up - first).head<2>().norm(), 0, 1e-12);
  }
}

TEST(RandomPlacement, KeepsSheetsApart) {
  const Cloths<3> cloths(PETSC_COMM_WORLD, {towels(12)});
  PlacementOptions<3> options = in_the_tub(PlacementRule::random, 0.12);
  options.clearance = 0.008;
  options.seed = 5;
  const Points<3> places = place_cloths<3>(cloths, {options}, {}, tub_space);
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = a + 1; b < places.size(); ++b)
      if (a / 30 != b / 30) {
        EXPECT_GE((places[a] - places[b]).norm(), 0.008 - 1e-12);
      }
}

// Exact frequencies of a free square plate (twist, saddle, breathing, 4/5, 6/7, 8), Kb = 1, side 1, mass 1 per area.
TEST(PlateModes, HaveTheExactFrequencies) {
  const std::array<double, 8> exact{13.4682, 19.5961, 24.2702, 34.8009, 34.8009, 61.0932, 61.0932, 63.6861};
  const BendingModuli bending = LinearFabric({.kb_s = 1, .kb_r = 1, .kt = 0.7, .poisson = 0.3}).bending();
  for (int mode = 1; mode <= 8; ++mode)
    EXPECT_NEAR(PlateMode(bending, 1, 1, mode).frequency(), exact[static_cast<std::size_t>(mode - 1)], 2e-4);
  const PlateMode twist(bending, 1, 1, 1);
  EXPECT_NEAR(twist(0.5, 0.5), -twist(-0.5, 0.5), 1e-6);
  EXPECT_NEAR(twist(0.3, 0.7), twist(0.7, 0.3), 1e-6);
  // of two with the same frequency, each has a direction of its own
  EXPECT_NEAR(PlateMode(bending, 1, 1, 4)(0.5, 0.5), -PlateMode(bending, 1, 1, 4)(-0.5, 0.5), 1e-5);
}

}  // namespace
}  // namespace washfsi::test
