// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/marker_layout/surface_markers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/polygon.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/sweeps.hpp"

namespace washfsi::test {
namespace {

const KernelMoments yang_moments(DeltaKernel::yang, 2);

MarkerLayout<3> layout(double cell) {
  return {Point<3>::Constant(cell), 1.2, yang_moments};
}

// How far from the middle of a ball of radius 1 its markers lie, at least and at most.
std::pair<double, double> radii(const MarkerLayout<3>& layout) {
  const Sphere<3> ball(1);
  const MarkerPatches<3> patches =
      surface_markers<3>(ball, Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(1.5)), layout);
  std::pair<double, double> result{2, 0};
  for (const auto& marker : patches.markers)
    result = {std::min(result.first, marker.norm()), std::max(result.second, marker.norm())};
  return result;
}

// A ball acts with its true radius if the mean distance of its markers' deltas from its middle is right, and if the
// stress of the eddies that their slip drives within it is taken into account, unless it turns.
TEST(SurfaceMarkers, LieBehindABall) {
  constexpr double cell = 0.1;
  const double flat = 0.5 * yang_moments.sheet_reach() * cell, bend = yang_moments.variance() * cell * cell;
  MarkerLayout<3> turning = layout(cell);
  turning.inside.turns = true;
  for (const double radius : {radii(turning).first, radii(turning).second})
    EXPECT_NEAR(radius, 1 - flat - bend, 0.02 * cell);
  const auto [least, most] = radii(layout(cell));
  for (const double radius : {least, most}) EXPECT_NEAR(radius, 1 - flat / (1 - 2.1 * flat) - bend, 0.02 * cell);
}

TEST(SurfaceMarkers, AreInPatchesThatCoverTheSurface) {
  const Sphere<3> ball(1);
  constexpr double cell = 0.1;
  const MarkerPatches<3> patches =
      surface_markers<3>(ball, Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(1.5)), layout(cell));
  ASSERT_EQ(patches.starts.back(), patches.markers.size());
  for (std::size_t p = 0; p < patches.size(); ++p) EXPECT_LT(patches.starts[p], patches.starts[p + 1]);
  for (int n = 0; n < 500; ++n) {  // places of a spiral on the ball
    const double z = -1 + (n + 0.5) / 250, turn = 2.4 * n, r = std::sqrt(1 - z * z);
    const Point<3> place(r * std::cos(turn), r * std::sin(turn), z);
    double nearest = 1;
    for (const auto& marker : patches.markers) nearest = std::min(nearest, (marker - place).norm());
    EXPECT_LT(nearest, 1.2 * cell) << place.transpose();
  }
}

// Uneven patches make the torque of a small blade a matter of chance.
TEST(SurfaceMarkers, OfSmallBladesAreInEvenPatches) {
  constexpr double cell = 0.1;
  for (const Point<2>& size : {Point<2>(4, 3.2), Point<2>(5, 4), Point<2>(5, 5), Point<2>(7.5, 6)}) {
    const Cuboid<3> blade(Point<3>(size[0], 0.32, size[1]) * cell);
    const MarkerPatches<3> patches =
        surface_markers<3>(blade, Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(1)), layout(cell));
    const Point<2> held = size - Point<2>::Constant(2 * 0.15);
    const double width = cell * std::sqrt(held.prod() / static_cast<double>(patches.size()));
    EXPECT_NEAR(width, 1.2 * layout(cell).spacing * cell, 0.2 * cell) << size.transpose();
    for (std::size_t p = 0; p < patches.size(); ++p) {
      double nearest = 1;
      for (std::size_t other = 0; other < patches.size(); ++other)
        if (other != p) nearest = std::min(nearest, (patches.middle(other) - patches.middle(p)).norm());
      EXPECT_GT(nearest, 0.65 * width) << size.transpose();
      EXPECT_LT(nearest, 1.3 * width) << size.transpose();
      EXPECT_LE(patches.starts[p + 1] - patches.starts[p], 4U);
    }
  }
}

TEST(SurfaceMarkers, DoNotDependOnTheRegion) {
  const Sphere<3> ball(0.5);
  const Point<3> margin = Point<3>::Constant(1);
  const auto here = surface_markers<3>(ball, Bounds<3>::round(Point<3>::Zero(), margin), layout(0.1));
  const auto there = surface_markers<3>(ball, Bounds<3>::round(Point<3>(0.013, 0.021, -0.037), margin), layout(0.1));
  EXPECT_EQ(here.markers, there.markers);
}

// How far from the middle of a plate across x its markers reach along y and z.
double reach_of(const MarkerPatches<3>& patches) {
  double widest = 0;
  for (const auto& marker : patches.markers) widest = std::max(widest, marker.tail<2>().cwiseAbs().maxCoeff());
  return widest;
}

constexpr double held_within = 0.34;  // of edges, in cells: half a spacing of 0.38, and 0.15

TEST(SurfaceMarkers, OfAThinPlateAreOneSheetWithinItsEdges) {
  constexpr double cell = 0.1;
  for (const double thickness : {0.002, 0.03, 0.1}) {
    const Cuboid<3> plate(Point<3>(thickness, 1, 1));
    const MarkerPatches<3> patches =
        surface_markers<3>(plate, Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(1)), layout(cell));
    for (const auto& marker : patches.markers) EXPECT_LT(std::abs(marker[0]), 0.1 * cell) << thickness;
    EXPECT_NEAR(reach_of(patches), 0.5 - held_within * cell, 0.05 * cell) << thickness;
  }
}

TEST(SurfaceMarkers, OfASheetThatWaterSlidesAlongLieFartherWithin) {
  constexpr double cell = 0.1;
  MarkerLayout<3> sliding = layout(cell);
  sliding.inner_water_slides = true;
  const Cuboid<3> plate(Point<3>(0.03, 1, 1));
  const auto patches = surface_markers<3>(plate, Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(1)), sliding);
  EXPECT_NEAR(reach_of(patches), 0.5 - (held_within + 0.2) * cell, 0.05 * cell);
}

// The vane of a machine in cells three times as wide as high, to which its upper and lower edges are blunt.
TEST(SurfaceMarkers, OfASheetInFlatCellsAreInItsMiddle) {
  const Point<3> cell(0.3, 0.3, 0.1);
  const Cuboid<3> vane(Point<3>(1.2 * cell[0], 3, 1));
  const auto patches =
      surface_markers<3>(vane, Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(4)), {cell, 1.2, yang_moments});
  double widest = 0;
  for (const auto& marker : patches.markers) {
    if (std::abs(marker[2]) > 0.5 - 1.5 * cell[2]) continue;
    EXPECT_LT(std::abs(marker[0]), 0.1 * cell[0]);
    widest = std::max(widest, std::abs(marker[1]));
  }
  EXPECT_NEAR(widest, 1.5 - held_within * cell[1], 0.06 * cell[1]);
}

// Blades of a turbine have equal markers, and keep them when it is turned.
TEST(SurfaceMarkers, TurnWithTheirPart) {
  constexpr double cell = 0.1, offset = 0.9;
  const auto blade = [] { return std::make_unique<Cuboid<3>>(Point<3>(0.5, 0.03, 0.4)); };
  const Bounds<3> region = Bounds<3>::round(Point<3>::Zero(), Point<3>::Constant(2));
  const Pose<3> aside = Pose<3>::at(Point<3>(offset, 0, 0), 0), turn = Pose<3>::at(Point<3>::Zero(), 0.3);
  const Placed<3> straight(blade(), aside), turned(blade(), turn.in_space(aside));
  const auto expected = surface_markers<3>(straight, region, layout(cell));
  const auto found = surface_markers<3>(turned, region, layout(cell));
  ASSERT_EQ(found.starts, expected.starts);
  ASSERT_GT(found.markers.size(), 20U);
  for (std::size_t m = 0; m < found.markers.size(); ++m)
    EXPECT_LT((found.markers[m] - turn.in_space(expected.markers[m])).norm(), 1e-9 * cell);
}

// What flows through a sheet goes through its gaps.
// Whether each marker has an image across an axis, in a patch that is the image of its own.
template <int Dim>
bool are_mirrored(const MarkerPatches<Dim>& patches, int axis) {
  const auto mirrored = [axis](Point<Dim> place) {
    place[axis] = -place[axis];
    return place;
  };
  const auto patch_at = [&](const Point<Dim>& place) {
    std::size_t patch = 0;
    while (patch < patches.size() &&
           std::none_of(patches.markers.begin() + static_cast<std::ptrdiff_t>(patches.starts[patch]),
                        patches.markers.begin() + static_cast<std::ptrdiff_t>(patches.starts[patch + 1]),
                        [&](const Point<Dim>& marker) { return (marker - place).norm() < 1e-12; }))
      ++patch;
    return patch;
  };
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const std::size_t image = patch_at(mirrored(patches.markers[patches.starts[p]]));
    if (image == patches.size()) return false;
    for (std::size_t m = patches.starts[p]; m < patches.starts[p + 1]; ++m)
      if (patch_at(mirrored(patches.markers[m])) != image) return false;
  }
  return true;
}

// A foil of the thickness 0.12, which is thin behind its middle.
Points<2> foil() {
  Points<2> upper, lower;
  for (int n = 0; n <= 40; ++n) {
    const double x = 0.5 * (1 - std::cos(std::acos(-1) * n / 40));
    const double y = 0.6 * (0.2969 * std::sqrt(x) - x * (0.126 + x * (0.3516 - x * (0.2843 - 0.1036 * x))));
    upper.emplace_back(x - 0.4, n < 40 ? y : 0);
    if (n > 0 && n < 40) lower.emplace_back(x - 0.4, -y);
  }
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  return upper;
}

TEST(SurfaceMarkers, OfThinShapesThatAreTheirOwnImagesAreSoToo) {
  const Bounds<2> around = Bounds<2>::round(Point<2>::Zero(), {1, 1});
  for (const double cell : {1.0 / 16, 1.0 / 33, 1.0 / 64}) {
    const MarkerLayout<2> layout{Point<2>::Constant(cell), 1.0, yang_moments};
    EXPECT_TRUE(are_mirrored<2>(surface_markers<2>(Polygon(foil()), around, layout), 1)) << cell;
    EXPECT_TRUE(are_mirrored<2>(surface_markers<2>(Cuboid<2>({0.7, 0.015}), around, layout), 1)) << cell;
    EXPECT_TRUE(are_mirrored<2>(surface_markers<2>(Cuboid<2>({0.015, 0.7}), around, layout), 0)) << cell;
  }
  const MarkerLayout<3> layout{Point<3>::Constant(1.0 / 20), 1.0, yang_moments};
  const Bounds<3> room = Bounds<3>::round(Point<3>::Zero(), {1, 1, 0.4});
  EXPECT_TRUE(are_mirrored<3>(surface_markers<3>(Extruded(std::make_unique<Polygon>(foil()), 0.5), room, layout), 1));
}

TEST(SurfaceMarkers, OfASheetLeaveNoGaps) {
  constexpr double cell = 0.1;
  const Cuboid<2> plate(Point<2>(0.03, 1));
  MarkerPatches<2> patches = surface_markers<2>(plate, Bounds<2>::round(Point<2>::Zero(), Point<2>::Constant(1)),
                                                {Point<2>::Constant(cell), 1.2, yang_moments});
  std::sort(patches.markers.begin(), patches.markers.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  for (std::size_t m = 1; m < patches.markers.size(); ++m) {
    EXPECT_LT(patches.markers[m][1] - patches.markers[m - 1][1], 1.2 * cell);
    EXPECT_GT(patches.markers[m][1] - patches.markers[m - 1][1], 0.5 * cell);
  }
}

TEST(Delta, OfYangHasConstantMoments) {
  for (int n = 0; n < 20; ++n) {
    const double start = 0.05 * n;
    double sum = 0, first = 0, second = 0;
    for (int i = -3; i <= 3; ++i) {
      const double x = i + start, weight = yang_delta(x);
      sum += weight;
      first += weight * x;
      second += weight * x * x;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(first, 0, 1e-12);
    EXPECT_NEAR(second, 0.3818000706405, 1e-12);
  }
}

}  // namespace
}  // namespace washfsi::test
