// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/intersections.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
ClothGroup<Dim> towel(PetscInt count, PetscInt markers) {
  ClothGroup<Dim> group;
  group.name = "towel";
  group.count = count;
  group.markers = {markers, Dim == 3 ? markers : 1};
  group.sheet.width = static_cast<std::size_t>(group.markers[1]);
  group.sheet.ds = group.sheet.dr = 1;
  return group;
}

template <int Dim>
struct Counted {
  Cloths<Dim> cloths;
  IntersectionCount<Dim> count;
  Counted(const ClothGroup<Dim>& group, const Points<Dim>& all, const Point<Dim>& lengths = Point<Dim>::Zero())
      : cloths(PETSC_COMM_WORLD, {group}), count(cloths, lengths) {
    count.count({all.begin() + cloths.begin(), all.begin() + cloths.end()});
  }
  double total() const { return count.total(); }
};

// Two sheets of one cell each: one in the plane z = 0 from (0, 0) to (1, 1), the other upright at x = 0.3, y from
// `from`, z from -0.5.
Points<3> crossed(double from) {
  Points<3> all{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
  for (const double y : {from, from + 1.0})
    for (const double z : {-0.5, 0.5}) all.push_back({0.3, y, z});
  return all;
}

TEST(Intersections, AreFoundWhereTwoSheetsCross) {
  const Counted<3> none(towel<3>(2, 2), crossed(1.001));
  EXPECT_EQ(none.total(), 0);
  // only the lower of the upright edges stands on the sheet
  const Counted<3> some(towel<3>(2, 2), crossed(0.9));
  EXPECT_GE(some.total(), 1);
  ASSERT_TRUE(some.count.example());
  EXPECT_NE(some.count.describe().find("towel 1"), std::string::npos);
  EXPECT_NE(some.count.describe().find("towel 2"), std::string::npos);
}

// Of four markers each; the same across periodic sides.
TEST(Intersections, AreFoundAcrossPeriodicSides) {
  Points<3> all = crossed(0.5);
  const double here = Counted<3>(towel<3>(2, 2), all).total();
  EXPECT_GT(here, 0);
  for (std::size_t m = 4; m < 8; ++m) all[m] += Point<3>(7, -14, 7);
  EXPECT_EQ(Counted<3>(towel<3>(2, 2), all).total(), 0);
  EXPECT_EQ(Counted<3>(towel<3>(2, 2), all, Point<3>(7, 7, 7)).total(), here);
}

TEST(Intersections, AreNoneOfSheetsInOnePlaneOrThatTouch) {
  Points<3> all = crossed(0);
  for (std::size_t m = 4; m < 8; ++m) all[m] = all[m - 4] + Point<3>(0.1, 0.3, 0);  // one over the other
  EXPECT_EQ(Counted<3>(towel<3>(2, 2), all).total(), 0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Point<3>(1, 2, 3).normalized()).toRotationMatrix();
  for (auto& place : all) place = turn * place;
  EXPECT_EQ(Counted<3>(towel<3>(2, 2), all).total(), 0);
  Points<3> standing = crossed(0.4);
  for (std::size_t m = 4; m < 8; ++m) standing[m][2] += 0.5;  // on the plane
  EXPECT_EQ(Counted<3>(towel<3>(2, 2), standing).total(), 0);
}

TEST(Intersections, AreFoundWithinOneCloth) {
  ClothGroup<2> fibre = towel<2>(1, 4);
  EXPECT_EQ(Counted<2>(fibre, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}).total(), 0);
  const Counted<2> loop(fibre, {{0, 0}, {1, 0}, {1, 1}, {0.5, -1}});
  EXPECT_EQ(loop.total(), 1);
  EXPECT_NE(loop.count.describe().find("goes through itself"), std::string::npos);
}

// Moeller and Trumbore's test of a ray, of all pairs.
double brute_force(const ClothGroup<3>& group, const Points<3>& all) {
  const auto n = static_cast<std::size_t>(group.markers[0]), of_cloth = n * n;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<std::array<std::size_t, 3>> faces;
  for (std::size_t c = 0; c < all.size() / of_cloth; ++c)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const std::size_t k = c * of_cloth + i * n + j;
        if (i + 1 < n) edges.push_back({k, k + n});
        if (j + 1 < n) edges.push_back({k, k + 1});
        if (i + 1 == n || j + 1 == n) continue;
        edges.push_back({k, k + n + 1});
        faces.push_back({k, k + n, k + n + 1});
        faces.push_back({k, k + n + 1, k + 1});
      }
  double total = 0;
  for (const auto& e : edges)
    for (const auto& f : faces) {
      if (std::any_of(f.begin(), f.end(), [&](std::size_t m) { return m == e[0] || m == e[1]; })) continue;
      const Point<3> way = all[e[1]] - all[e[0]], a = all[f[1]] - all[f[0]], b = all[f[2]] - all[f[0]];
      Eigen::Matrix3d system;
      system << -way, a, b;
      const Point<3> part = system.inverse() * (all[e[0]] - all[f[0]]);
      if (part[0] > 0 && part[0] < 1 && part[1] > 0 && part[2] > 0 && part[1] + part[2] < 1) total += 1;
    }
  return total;
}

TEST(Intersections, AreAsManyAsBruteForceFinds) {
  const ClothGroup<3> group = towel<3>(5, 4);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Points<3> all = random_points<3>(80, seed, 3);
    const double expected = brute_force(group, all);
    EXPECT_GT(expected, 100);
    EXPECT_EQ(Counted<3>(group, all).total(), expected);
  }
}

}  // namespace
}  // namespace washfsi::test
