// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/body_depths.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/motion/repeat_bodies.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/primitives.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
Grid<Dim> box(bool is_periodic) {
  GridShape<Dim> shape;
  shape.cells.fill(24);
  shape.lower.setConstant(-1);
  shape.upper.setConstant(1);
  shape.periodic.fill(is_periodic);
  return Grid<Dim>(PETSC_COMM_WORLD, shape);
}

template <int Dim>
std::vector<Body<Dim>> ball(double radius, const Point<Dim>& center) {
  std::vector<Body<Dim>> bodies(1);
  bodies[0].name = "ball";
  bodies[0].shape = std::make_unique<Sphere<Dim>>(radius);
  bodies[0].motion.center = center;
  return bodies;
}

template <int Dim>
ClothGroup<Dim> towels(PetscInt count, PetscInt rows, PetscInt columns) {
  ClothGroup<Dim> group;
  group.name = "towel";
  group.count = count;
  group.markers = {rows, columns};
  group.sheet.width = static_cast<std::size_t>(columns);
  group.sheet.ds = group.sheet.dr = 1;
  return group;
}

template <int Dim>
struct Looked {
  Cloths<Dim> cloths;
  Grid<Dim> grid;
  std::vector<Body<Dim>> bodies;
  BodyDepths<Dim> depths;
  Looked(const ClothGroup<Dim>& group, const Points<Dim>& all, std::vector<Body<Dim>> given, bool is_periodic = false)
      : cloths(PETSC_COMM_WORLD, {group}),
        grid(box<Dim>(is_periodic)),
        bodies(repeat_bodies<Dim>(grid, std::move(given))),
        depths(cloths, grid, bodies) {
    depths.look({all.begin() + cloths.begin(), all.begin() + cloths.end()}, 0);
  }
  double total() const { return depths.total(); }
  double depth() const { return depths.of_groups()[0]; }
};

// Of one cell, a tenth wide, in the plane z = 0.
const Points<3> cell{{0, 0, 0}, {0, 0.1, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}};

TEST(BodyDepths, SeeABallInTheMiddleOfATriangle) {
  const Point<3> within(0.03, 0.06, 0);
  const Looked<3> through(towels<3>(1, 2, 2), cell, ball<3>(0.005, within));
  EXPECT_EQ(through.total(), 1);
  EXPECT_GT(through.depth(), 0.001);
  EXPECT_LE(through.depth(), 0.005);
  EXPECT_NE(through.depths.example().find("towel 1 reaches"), std::string::npos);
  EXPECT_NE(through.depths.example().find("into ball"), std::string::npos);
  for (const double above : {0.0051, 0.008, 0.03}) {
    const Looked<3> over(towels<3>(1, 2, 2), cell, ball<3>(0.005, within + above * Point<3>::UnitZ()));
    EXPECT_EQ(over.total(), 0) << above;
    EXPECT_EQ(over.depth(), 0) << above;
    EXPECT_TRUE(over.depths.example().empty());
  }
}

TEST(BodyDepths, CountBothTrianglesOfACellThroughTheirDiagonal) {
  EXPECT_EQ(Looked<3>(towels<3>(1, 2, 2), cell, ball<3>(0.003, {0.05, 0.05, 0.001})).total(), 2);
}

TEST(BodyDepths, SeeBodiesThroughPeriodicSides) {
  for (const bool is_periodic : {false, true})
    EXPECT_EQ(Looked<3>(towels<3>(1, 2, 2), cell, ball<3>(0.005, {2.03, -1.94, 2}), is_periodic).total(), is_periodic);
}

TEST(BodyDepths, SeeEdgesOfFibres) {
  EXPECT_EQ(
      Looked<3>(towels<3>(1, 3, 1), {{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}}, ball<3>(0.01, {0.15, 0.005, 0})).total(), 1);
  EXPECT_EQ(Looked<2>(towels<2>(1, 3, 1), {{0, 0}, {0.1, 0}, {0.2, 0}}, ball<2>(0.01, {0.15, 0.005})).total(), 1);
}

// Against the nearest places of triangles to the middles of balls, in closed form by their planes and edges.
double distance_from_triangle(const Point<3>& place, const std::array<Point<3>, 3>& t) {
  double least = INFINITY;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point<3> way = t[(i + 1) % 3] - t[i];
    const double part = std::clamp((place - t[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (place - t[i] - part * way).norm());
  }
  Eigen::Matrix<double, 3, 2> sides;
  sides << t[1] - t[0], t[2] - t[0];
  const Eigen::Vector2d part = (sides.transpose() * sides).inverse() * sides.transpose() * (place - t[0]);
  if (part.minCoeff() > 0 && part.sum() < 1) least = std::min(least, (place - t[0] - sides * part).norm());
  return least;
}

TEST(BodyDepths, AreThoseOfClosedForms) {
  constexpr PetscInt n = 5;
  const double radius = 0.15;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Points<3> all = random_points<3>(n * n, seed, 0.4);
    const Point<3> center = random_points<3>(1, seed + 100, 0.3)[0];
    double total = 0, depth = 0;
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t j = 0; j + 1 < n; ++j) {
        const std::size_t k = i * n + j;
        for (const auto& face :
             {std::array{all[k], all[k + n], all[k + n + 1]}, std::array{all[k], all[k + n + 1], all[k + 1]}}) {
          const double inside = radius - distance_from_triangle(center, face);
          total += inside > 0 ? 1 : 0;
          depth = std::max(depth, inside);
        }
      }
    const Looked<3> looked(towels<3>(1, n, n), all, ball<3>(radius, center));
    EXPECT_EQ(looked.total(), total);
    EXPECT_LE(looked.depth(), depth + 1e-12);
    EXPECT_GE(looked.depth(), depth - 0.08);  // a tenth of the largest face's size
  }
}

}  // namespace
}  // namespace washfsi::test
