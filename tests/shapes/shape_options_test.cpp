// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/shape_options.hpp"

#include <fstream>
#include <numbers>

#include <gtest/gtest.h>

#include "support/option_database.hpp"
#include "support/random_points.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/polygon.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/sweeps.hpp"
#include "washfsi/shapes/vaned.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
ShapePtr<Dim> read(const std::string& text) {
  const OptionDatabase database(text);
  Options options(PETSC_COMM_WORLD);
  auto shape = shape_from_options<Dim>(options, "a", 0.01);
  options.reject_unread();
  return shape;
}

template <int Dim>
void expect_same(const ShapePtr<Dim>& shape, const Shape<Dim>& expected) {
  for (const auto& place : random_points<Dim>(50, 21, 0.5))
    EXPECT_NEAR(shape->distance(place), expected.distance(place), 1e-14);
}

TEST(ShapeOptions, ReadThePrimitives) {
  expect_same<2>(read<2>("-a_shape sphere"), Sphere<2>(0.1));
  expect_same<2>(read<2>("-a_shape sphere -a_radius 0.3"), Sphere<2>(0.3));
  expect_same<3>(read<3>("-a_shape box -a_size 0.1,0.2,0.3"), Cuboid<3>({0.1, 0.2, 0.3}));
  expect_same<3>(read<3>("-a_shape halfspace -a_normal 0,0,-2"), HalfSpace<3>({0, 0, -1}));
  expect_same<2>(read<2>("-a_shape capsule -a_from -.1,0 -a_to 0.2,0.2 -a_radius 0.1"),
                 Capsule<2>({-0.1, 0}, {0.2, 0.2}, 0.1));
  expect_same<3>(read<3>("-a_shape cylinder -a_radius 0.2 -a_height 0.5"),
                 Extruded(std::make_unique<Sphere<2>>(0.2), 0.5));
  const Points<2> triangle{{0, 0}, {0.3, 0}, {0, 0.3}};
  expect_same<2>(read<2>("-a_shape polygon -a_vertices 0,0,0.3,0,0,0.3"), Polygon(triangle));
  expect_same<3>(read<3>("-a_shape polygon -a_vertices 0,0,0.3,0,0,0.3 -a_height 0.2"),
                 Extruded(std::make_unique<Polygon>(triangle), 0.2));
  expect_same<3>(read<3>("-a_shape revolution -a_profile 0,0,0.3,0,0,0.3"),
                 Revolved(std::make_unique<Polygon>(triangle, Polygon::Kind::profile)));
  expect_same<2>(read<2>("-a_shape vaned -a_hub_radius 0.05 -a_vanes 5"), *vaned({.hub_radius = 0.05, .vanes = 5}));
  expect_same<3>(read<3>("-a_shape vaned -a_height 0.2"), Extruded(vaned({}), 0.2));
}

TEST(ShapeOptions, ReadATree) {
  const auto agitator = read<3>(
      "-a_shape union -a_parts hub,vane -a_hub_shape cylinder -a_hub_radius 0.07 -a_hub_height 0.4 "
      "-a_vane_shape difference -a_vane_parts plate,hole -a_vane_repeat 4 -a_vane_offset 0.1,0,0 "
      "-a_vane_plate_shape box -a_vane_plate_size 0.2,0.02,0.4 "
      "-a_vane_hole_shape capsule -a_vane_hole_from 0,-1,0 -a_vane_hole_to 0,1,0 -a_vane_hole_radius 0.03");
  EXPECT_NEAR(agitator->distance({0, 0, 0.2}), 0, 1e-15);
  for (int k = 0; k < 4; ++k) {
    const auto pose = Pose<3>::at(Point<3>::Zero(), -0.5 * std::numbers::pi * k);
    EXPECT_NEAR(agitator->distance(pose.in_body_frame({0.25, 0, 0})), 0.05, 1e-14);  // before the end of a vane
    EXPECT_NEAR(agitator->distance(pose.in_body_frame({0.1, 0, 0})), 0.03, 1e-14);   // in its hole
    EXPECT_NEAR(agitator->distance(pose.in_body_frame({0.17, 0.01, 0})), 0, 1e-14);
  }
}

// First rounding, then turn and offset, then repeat, then inverted.
TEST(ShapeOptions, PlaceAShapeInOneOrder) {
  const auto shape =
      read<2>("-a_shape box -a_size 0.2,0.1 -a_rounding 0.05 -a_turn 90 -a_offset 0.3,0 -a_repeat 2 -a_inverted");
  EXPECT_NEAR(shape->distance({0.4, 0}), 0, 1e-15);
  EXPECT_NEAR(shape->distance({-0.3, 0.25}), -0.1, 1e-14);
  EXPECT_NEAR(shape->distance({0, 0}), -0.2, 1e-15);
}

/// The one line by which options are refused; empty if they are not.
std::string refusal(int dim, const std::string& text) {
  return refusal_of<InputError>([&] {
    if (dim == 2)
      (void)read<2>(text);
    else
      (void)read<3>(text);
  });
}

TEST(ShapeOptions, RefuseWithOneLineThatNamesOptionAndValue) {
  const std::vector<std::tuple<int, std::string, std::string>> cases{
      {2, "-a_shape teapot", "-a_shape teapot: must be one of sphere|box|"},
      {2, "-a_shape cylinder", "-a_shape cylinder: must be one of"},
      {2, "-a_rounding 0.1", "-a_shape is missing"},
      {2, "-a_shape box", "-a_size is missing"},
      {2, "-a_shape box -a_size 0.1,-1", "-a_size 0.1,-1: must be numbers > 0"},
      {2, "-a_shape box -a_size 0.1", "-a_size 0.1: must be 2 numbers"},
      {3, "-a_shape cylinder -a_radius 1", "-a_height is missing"},
      {3, "-a_shape cylinder -a_radius 1 -a_height 0", "-a_height 0: must be a number > 0"},
      {2, "-a_shape halfspace -a_normal 0,0", "-a_normal 0,0: must be a direction"},
      {2, "-a_shape capsule -a_from 0,0 -a_radius 1", "-a_to is missing"},
      {2, "-a_shape polygon", "-a_vertices is missing"},
      {2, "-a_shape polygon -a_vertices 0,0,1,0", "-a_vertices 0,0,1,0: must be"},
      {2, "-a_shape polygon -a_vertices 0,0,1,0,1", "-a_vertices 0,0,1,0,1: must be an even count"},
      {2, "-a_shape polygon -a_vertices 0,0,3,0,0,1,2,2", "cross"},
      {2, "-a_shape polygon -a_vertices 0,0,1,1,2,2", "area"},
      {3, "-a_shape revolution -a_profile 0,0,1,0,-1,1", "-a_profile 0,0,1,0,-1,1: must be"},
      {2, "-a_rounding -1", "-a_rounding -1: must be a number >= 0"},
      {2, "-a_repeat 0", "-a_repeat 0: must be a whole number"},
      {2, "-a_shape union", "-a_parts is missing"},
      {2, "-a_shape union -a_parts b,b", "-a_parts b,b: must be different names"},
      {2, "-a_shape union -a_parts b,b_c -a_b_shape union -a_b_parts c", "-a_b_parts a_b_c: this name is taken"},
      {2, "-a_shape union -a_parts b -a_b_shape blob", "-a_b_shape blob: must be one of"},
      {2, "-a_shape sphere -a_height 1", "-a_height 1: no part"},
      {2, "-a_shape union -a_parts b -a_b_shape sphere -a_b_radios 1", "did you mean -a_b_radius?"},
  };
  for (const auto& [dim, text, words] : cases) {
    const std::string line = refusal(dim, text);
    EXPECT_NE(line.find(words), std::string::npos) << text << "\n  " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(BodyOptions, ResolvedOptionsGiveTheSameBody) {
  std::string resolved;
  const auto body = [&](const std::string& text) {
    const OptionDatabase database(text);
    Options options(PETSC_COMM_WORLD);
    auto read_body = Body<2>::from_options(options, "a", 0.01);
    resolved = options.resolved();
    return read_body;
  };
  const auto first = body(
      "-a_shape difference -a_parts b,c -a_b_radius 0.4 -a_c_shape polygon -a_c_vertices 0,0,0.31,0,0,0.3 -a_c_turn 17 "
      "-a_velocity 0.1,-0.2 -a_angular_speed 2 -a_frequency 0.3 -a_center 0.01,0.02");
  const std::string written = resolved;
  const auto second = body(written);
  EXPECT_EQ(written, resolved);
  for (const auto& place : random_points<2>(50, 2, 0.5))
    EXPECT_EQ(first.distance(place, 0.7), second.distance(place, 0.7));
}

/// Reads a motion from a file with this content.
RigidMotion<2> motion_of(const std::string& content, const std::string& more = "") {
  const ScratchFolder folder;
  folder.write("motion.csv", content);
  const OptionDatabase database("-a_motion_file " + folder.file("motion.csv") + " " + more);
  Options options(PETSC_COMM_WORLD);
  return RigidMotion<2>::from_options(options, "a");
}

TEST(MotionFile, GivesDisplacementsFromTheCentre) {
  const auto motion =
      motion_of("time,x,y,angle\r\n# s, m, m, rad\n\n0, 0, 0, 0\r\n1,0.5,0,1\n2,1,-1,2\n", "-a_center 3,4");
  EXPECT_LE((motion.center_at(1) - Point<2>(3.5, 4)).norm(), 1e-14);
  EXPECT_NEAR(motion.angle(9), 2, 1e-14);
}

TEST(MotionFile, IsRefusedWithOneLine) {
  const std::vector<std::tuple<std::string, std::string, std::string>> cases{
      {"", "", "at least 2 rows"},
      {"0,0,0,0\n", "", "at least 2 rows"},
      {"0,0,0,0\n1,0,0\n", "", "line 2 must be the 4 numbers time,x,y,angle"},
      {"0,0,0,0\n1,0,0,zero\n", "", "line 2 must be"},
      {"time,x,y,z,angle\n0,0,0,0,0\n", "", "line 1 must be"},
      {"0,0,0,0\n1,0,0,nan\n", "", "line 2 must be"},
      {"0,0,0,0\n1,0,0,1\n\n1,0,0,2\n", "", "line 4: time 1 must be later"},
      {"0,0,0,0\n1,0,0,1\n", "-a_velocity 1,0", "cannot be combined"},
      {"0,0,0,0\n1,0,0,1\n", "-a_motion_file nowhere.csv", "-a_motion_file nowhere.csv: cannot be read"},
      {"0,0,0,0\n1,0,0,1\n", "-a_motion_file .", "-a_motion_file .: cannot be read"},
  };
  for (const auto& [content, more, words] : cases)
    expect_refusal<InputError>([&table = content, &options = more] { (void)motion_of(table, options); }, words);
}

}  // namespace
}  // namespace washfsi::test
