// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/zero_surface.hpp"

#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "support/unit_grid.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
SimplexMesh<Dim> ball(PetscInt n, double radius, const Point<Dim>& center) {
  const Sphere<Dim> sphere(radius);
  return zero_surface<Dim>(unit_grid<Dim>(n), [&](const Point<Dim>& place) { return sphere.distance(place - center); });
}

// Of all ranks: the surface, and what it encloses if it faces outwards.
std::array<double, 2> area_and_volume(const SimplexMesh<3>& mesh, const Point<3>& center) {
  double area = 0, volume = 0;
  for (const auto& [a, b, c] : mesh.facets) {
    const Point<3> twice = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    area += 0.5 * twice.norm();
    volume += twice.dot(mesh.vertices[a] - center) / 6;
  }
  return {ordered_sum(PETSC_COMM_WORLD, area), ordered_sum(PETSC_COMM_WORLD, volume)};
}

TEST(ZeroSurface, OfABallIsClosedAndOfItsSize) {
  constexpr double radius = 0.3;
  for (const Point<3>& center : {Point<3>(0.5, 0.5, 0.5), Point<3>(0.513, 0.472, 0.391)}) {
    const auto [area, volume] = area_and_volume(ball<3>(20, radius, center), center);
    EXPECT_NEAR(area, 4 * std::numbers::pi * radius * radius, 0.01 * area);
    EXPECT_NEAR(volume, 4 * std::numbers::pi / 3 * radius * radius * radius, 0.01 * volume);
  }
}

TEST(ZeroSurface, ConvergesAtSecondOrder) {
  const Point<3> center(0.513, 0.472, 0.391);
  std::array<double, 2> errors{};
  for (const PetscInt n : {16, 32}) {
    const double volume = area_and_volume(ball<3>(n, 0.3, center), center)[1];
    errors[n / 32] = std::abs(volume / (4 * std::numbers::pi / 3 * 0.027) - 1);
  }
  EXPECT_LT(errors[1], 0.3 * errors[0]);
}

// Every edge has a facet on either side, passed once each way, also where ranks meet.
TEST(ZeroSurface, HasNoHoles) {
  const auto mesh = ball<3>(12, 0.3, {0.51, 0.47, 0.39});
  if (rank_of(PETSC_COMM_WORLD) > 0) {
    EXPECT_TRUE(mesh.facets.empty() && mesh.vertices.empty());
    return;
  }
  std::map<std::pair<std::size_t, std::size_t>, int> passes;
  for (const auto& facet : mesh.facets)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = facet[k], to = facet[(k + 1) % 3];
      passes[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : 1000;
    }
  EXPECT_GT(passes.size(), 100U);
  for (const auto& [edge, count] : passes) EXPECT_EQ(count, 1001);
}

// Of a plate that is thinner than a cell, however it lies: between the nodes that thick bodies need it would slip.
TEST(ZeroSurface, OfAThinPlateIsWhole) {
  const Cuboid<3> plate({0.5, 0.3 / 24, 0.2});
  const Point<3> center(0.513, 0.472, 0.391);
  for (const double angle : {0.0, 0.4, 1.0}) {
    const auto pose = Pose<3>::at(center, angle);
    const auto mesh = zero_surface<3>(unit_grid<3>(24),
                                      [&](const Point<3>& place) { return plate.distance(pose.in_body_frame(place)); });
    const auto [area, volume] = area_and_volume(mesh, center);
    EXPECT_NEAR(area, 2 * (0.1 + 0.7 * 0.3 / 24), 0.06 * area) << angle;
    EXPECT_NEAR(volume, 0.1 * 0.3 / 24, 0.2 * volume) << angle;
  }
}

TEST(ZeroSurface, OfACircleIsItsLine) {
  const Point<2> center(0.45, 0.52);
  const SimplexMesh<2> mesh = ball<2>(32, 0.3, center);
  double length = 0, area = 0;
  for (const auto& [a, b] : mesh.facets) {
    const Point<2> from = mesh.vertices[a] - center, to = mesh.vertices[b] - center;
    length += (to - from).norm();
    area += 0.5 * (from[0] * to[1] - from[1] * to[0]);
  }
  EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, length), 2 * std::numbers::pi * 0.3, 0.01);
  EXPECT_NEAR(std::abs(ordered_sum(PETSC_COMM_WORLD, area)), std::numbers::pi * 0.09, 0.003);
}

}  // namespace
}  // namespace washfsi::test
