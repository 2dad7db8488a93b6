// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <petscsys.h>

#include "washfsi/marker_layout/surface_markers.hpp"
#include "washfsi/shapes/primitives.hpp"

namespace washfsi::test {
namespace {

MarkerLayout<3> layout(MPI_Comm comm) {
  return {
      .cell = Point<3>(0.1, 0.1, 0.07), .spacing = 1.2, .moments = KernelMoments(DeltaKernel::yang, 2), .comm = comm};
}

void expect_the_same(const MarkerPatches<3>& found, const MarkerPatches<3>& expected) {
  EXPECT_GT(found.size(), 0u);
  EXPECT_EQ(found.markers, expected.markers);
  EXPECT_EQ(found.feet, expected.feet);
  EXPECT_EQ(found.starts, expected.starts);
}

TEST(SurfaceMarkers, ThatRanksLayTogetherAreThoseOfEachAlone) {
  const auto region = Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(1));
  const Sphere<3> ball(0.45);
  expect_the_same(surface_markers<3>(ball, region, layout(PETSC_COMM_WORLD)),
                  surface_markers<3>(ball, region, layout(PETSC_COMM_SELF)));
  const Cuboid<3> plate(Point<3>(0.05, 0.8, 0.7));
  expect_the_same(surface_markers<3>(plate, region, layout(PETSC_COMM_WORLD)),
                  surface_markers<3>(plate, region, layout(PETSC_COMM_SELF)));
}

// Ranks take parts by turns, of one surface or of several.
TEST(SurfaceMarkers, OfSeveralSurfacesAreThoseOfEachAlone) {
  const auto region = Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(1));
  const auto elsewhere = Bounds<3>::round(Point<3>::Constant(9), Point<3>::Constant(1));
  const Sphere<3> ball(0.45);
  const Cuboid<3> plate(Point<3>(0.05, 0.8, 0.7));
  const MarkerLayout<3> together = layout(PETSC_COMM_WORLD);
  const auto found =
      surface_markers<3>({{&ball, region, together}, {&ball, elsewhere, together}, {&plate, region, together}});
  ASSERT_EQ(found.size(), 3u);
  expect_the_same(found[0], surface_markers<3>(ball, region, layout(PETSC_COMM_SELF)));
  EXPECT_EQ(found[1].size(), 0u);
  expect_the_same(found[2], surface_markers<3>(plate, region, layout(PETSC_COMM_SELF)));
}

// Of which there may be none.
TEST(SurfaceMarkers, OfNothingAreNoneOnAllRanks) {
  const auto elsewhere = Bounds<3>::round(Point<3>::Constant(9), Point<3>::Constant(1));
  EXPECT_EQ(surface_markers<3>(Sphere<3>(0.45), elsewhere, layout(PETSC_COMM_WORLD)).size(), 0u);
}

}  // namespace
}  // namespace washfsi::test
