// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/geometry/near_search.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/geometry/nearest.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
std::vector<Bounds<Dim>> random_boxes(std::size_t count, unsigned seed, double size) {
  const Points<Dim> middles = random_points<Dim>(count, seed), halves = random_points<Dim>(count, seed + 1, size);
  std::vector<Bounds<Dim>> boxes;
  for (std::size_t n = 0; n < count; ++n) boxes.push_back(Bounds<Dim>::round(middles[n], halves[n].cwiseAbs()));
  return boxes;
}

template <int Dim>
bool overlap(const Bounds<Dim>& a, const Bounds<Dim>& b, const PeriodicSpace<Dim>& space) {
  for (int d = 0; d < Dim; ++d) {
    double apart = std::abs((a.lower[d] + a.upper[d] - b.lower[d] - b.upper[d]) / 2);
    if (space.periodic[d]) apart = std::abs(std::remainder(apart, space.length[d]));
    if (apart > (a.upper[d] - a.lower[d] + b.upper[d] - b.lower[d]) / 2) return false;
  }
  return true;
}

// Against a comparison of all with all.
template <int Dim>
void expect_all_found(const PeriodicSpace<Dim>& space, double size) {
  const auto boxes = random_boxes<Dim>(300, 1, size), asked = random_boxes<Dim>(100, 7, 2 * size);
  const NearSearch<Dim> search(boxes, Point<Dim>::Constant(2 * size), hull(asked), space);
  std::size_t more = 0, all = 0;
  for (const auto& bounds : asked) {
    const std::vector<std::size_t> found = search.near(bounds);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::size_t n = 0; n < boxes.size(); ++n) {
      const bool is_near = overlap(boxes[n], bounds, space);
      const bool is_found = std::binary_search(found.begin(), found.end(), n);
      EXPECT_TRUE(is_found || !is_near) << n;
      more += is_found && !is_near;
      all += is_found;
    }
  }
  if (size >= 0.1) {
    EXPECT_GT(all, 0U);
  }
  const bool periodic = std::find(space.periodic.begin(), space.periodic.end(), true) != space.periodic.end();
  EXPECT_LE(more, periodic ? boxes.size() * asked.size() / 4 : 0U);
}

TEST(NearSearch, FindsAllThatOverlapAndNoOthers) {
  for (const double size : {0.01, 0.1, 0.7}) {
    expect_all_found<2>({}, size);
    expect_all_found<3>({}, size);
  }
}

TEST(NearSearch, FindsImagesAlongPeriodicAxes) {
  PeriodicSpace<2> plane{{-1, -1}, {2, 2}, {true, false}};
  PeriodicSpace<3> space{{-1, -1, -1}, {2, 2, 2}, {true, false, true}};
  for (const double size : {0.01, 0.1}) {
    expect_all_found<2>(plane, size);
    expect_all_found<3>(space, size);
  }
}

TEST(NearSearch, WorksWithoutBoxesAndWithOneBin) {
  const NearSearch<3> empty({}, Point<3>::Ones(), {Point<3>::Zero(), Point<3>::Ones()});
  EXPECT_TRUE(empty.near({Point<3>::Zero(), Point<3>::Ones()}).empty());
  const std::vector<Bounds<3>> one{{Point<3>::Zero(), Point<3>::Zero()}};
  const NearSearch<3> search(one, Point<3>::Constant(100), hull(one));
  EXPECT_EQ(search.near(one[0]).size(), 1U);
}

// Against the least of many points of the triangle.
TEST(NearestOnTriangle, IsNearerThanAllOthers) {
  const Points<3> corners = random_points<3>(60, 3), places = random_points<3>(20, 4, 2);
  for (std::size_t n = 0; n < 20; ++n) {
    const Triangle triangle{corners[3 * n], corners[3 * n + 1], corners[3 * n + 2]};
    const NearestOnTriangle nearest = nearest_on(triangle, places[n]);
    constexpr int fine = 200;
    double least = 1e300, apart = 1e300;
    for (int i = 0; i <= fine; ++i)
      for (int j = 0; i + j <= fine; ++j) {
        const double a = static_cast<double>(i) / fine, b = static_cast<double>(j) / fine;
        const Point<3> point = (1 - a - b) * triangle[0] + a * triangle[1] + b * triangle[2];
        least = std::min(least, (point - places[n]).norm());
        apart = std::min(apart, (point - nearest.place).norm());
      }
    EXPECT_LE((nearest.place - places[n]).norm(), least + 1e-12);
    EXPECT_GE((nearest.place - places[n]).norm(), least - 0.02);
    EXPECT_LE(apart, 0.02);  // it lies on the triangle
  }
}

}  // namespace
}  // namespace washfsi::test
