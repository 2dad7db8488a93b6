// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/machine/placement.hpp"

#include <gtest/gtest.h>

#include "washfsi/body/combinations.hpp"
#include "washfsi/body/primitives.hpp"
#include "washfsi/body/vaned.hpp"
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
  result.size = size;
  result.markers = markers;
  result.fibre.spacing = size / static_cast<double>(markers);
  return result;
}

PlacementOptions<2> placed(const std::string& rule, PetscInt seed = 1) {
  PlacementOptions<2> options;
  options.rule = rule;
  options.radius = 0.3186;
  options.clearance = 0.012;
  options.seed = seed;
  return options;
}

const Point<2> lower(-0.3456, -0.3456), upper(0.3456, 0.3456);

TEST(RandomPlacement, KeepsClearOfBodiesAndOfEachOther) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("long", 10, 0.2592, 24), group("short", 10, 0.1728, 16)});
  const std::vector<Body<2>> bodies = washtub();
  const Points<2> places = place_cloths<2>(cloths, {placed("random"), placed("random", 2)}, bodies, lower, upper);
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

TEST(RandomPlacement, DependsOnTheSeedOnly) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("towel", 5, 0.2, 10)});
  const std::vector<Body<2>> bodies = washtub();
  const Points<2> first = place_cloths<2>(cloths, {placed("random", 7)}, bodies, lower, upper);
  EXPECT_EQ(first, place_cloths<2>(cloths, {placed("random", 7)}, bodies, lower, upper));
  EXPECT_NE(first, place_cloths<2>(cloths, {placed("random", 8)}, bodies, lower, upper));
}

TEST(Placement, StartsAllClothsUnstretched) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("towel", 4, 0.08, 8)});
  for (const char* rule : {"line", "stack", "radial", "random"}) {
    PlacementOptions<2> options = placed(rule);
    options.center =
        std::string(rule) == "radial" || std::string(rule) == "random" ? Point<2>(0, 0) : Point<2>(-0.15, 0);
    const Points<2> places = place_cloths<2>(cloths, {options}, {}, lower, upper);
    for (std::size_t k = 1; k < 8; ++k) EXPECT_NEAR((places[k] - places[k - 1]).norm(), 0.01, 1e-15) << rule;
  }
}

TEST(Placement, RefusesClothInASolid) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("towel", 1, 0.2, 10)});
  EXPECT_THROW((void)place_cloths<2>(cloths, {placed("line")}, washtub(), lower, upper), InputError);
}

TEST(RandomPlacement, SaysSoWhenThereIsNoRoom) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, {group("carpet", 1, 0.7, 10)});
  EXPECT_THROW((void)place_cloths<2>(cloths, {placed("random")}, washtub(), lower, upper), InputError);
}

}  // namespace
}  // namespace washfsi::test
