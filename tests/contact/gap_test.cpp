// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/gap.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/contact/barrier_function.hpp"
#include "washfsi/contact/collision.hpp"

namespace washfsi::test {
namespace {

template <int Dim>
PairPoints<Dim> pair_at(const Points<Dim>& points, std::size_t first) {
  PairPoints<Dim> places;
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = points[first + i];
  return places;
}

template <int Dim>
std::vector<PairKind> kinds() {
  if constexpr (Dim == 2) return {PairKind::point_facet};
  return {PairKind::point_facet, PairKind::edge_edge};
}

// Random shares of a facet, with those on its borders among them.
std::vector<double> facet_shares(std::size_t markers, std::mt19937_64& engine) {
  std::uniform_real_distribution<double> any(-0.3, 1);
  std::vector<double> shares(markers);
  double sum = 0;
  while (sum == 0) {
    sum = 0;
    for (double& share : shares) sum += share = std::max(0.0, any(engine));
  }
  for (double& share : shares) share /= sum;
  return shares;
}

template <int Dim>
void finds_the_shortest_way() {
  const Points<Dim> points = random_points<Dim>(4000, 1);
  std::mt19937_64 engine(2);
  for (std::size_t n = 0; n + 4 < points.size(); n += 4)
    for (const PairKind kind : kinds<Dim>()) {
      const PairPoints<Dim> places = pair_at(points, n);
      const Gap<Dim> gap = gap_of<Dim>(kind, places);
      const std::size_t of_first = markers_of_first(kind);
      Point<Dim> way = Point<Dim>::Zero();
      double first = 0, second = 0;
      for (std::size_t i = 0; i < places.size(); ++i) {
        way += gap.shares[i] * places[i];
        (i < of_first ? first : second) += gap.shares[i];
        EXPECT_GE(i < of_first ? gap.shares[i] : -gap.shares[i], -1e-14);
      }
      EXPECT_NEAR(first, 1, 1e-14);
      EXPECT_NEAR(second, -1, 1e-14);
      EXPECT_LE((way - gap.distance * gap.normal).norm(), 1e-14);
      for (int trial = 0; trial < 50; ++trial) {
        const auto a = facet_shares(of_first, engine), b = facet_shares(places.size() - of_first, engine);
        Point<Dim> other = Point<Dim>::Zero();
        for (std::size_t i = 0; i < places.size(); ++i)
          other += i < of_first ? Point<Dim>(a[i] * places[i]) : Point<Dim>(-b[i - of_first] * places[i]);
        EXPECT_GE(other.norm(), gap.distance - 1e-13);
      }
    }
}

TEST(Gap, IsTheShortestWayBetweenTheFacets) {
  finds_the_shortest_way<2>();
  finds_the_shortest_way<3>();
}

TEST(Gap, ChangesAsItsSharesSay) {
  const Points<3> points = random_points<3>(400, 3), directions = random_points<3>(400, 4);
  constexpr double e = 1e-6;
  for (std::size_t n = 0; n + 4 < points.size(); n += 4)
    for (const PairKind kind : kinds<3>()) {
      PairPoints<3> places = pair_at(points, n), more = places, less = places;
      const Gap<3> gap = gap_of<3>(kind, places);
      double slope = 0;
      for (std::size_t i = 0; i < places.size(); ++i) {
        more[i] += e * directions[n + i];
        less[i] -= e * directions[n + i];
        slope += gap.shares[i] * gap.normal.dot(directions[n + i]);
      }
      const double difference = gap_of<3>(kind, more).distance - gap_of<3>(kind, less).distance;
      EXPECT_NEAR(difference / (2 * e), slope, 1e-4);
    }
}

TEST(Gap, KnowsDegenerateFacets) {
  const Point<3> o = Point<3>::Zero(), x = Point<3>::UnitX(), z = Point<3>::UnitZ();
  EXPECT_NEAR(gap_of<3>(PairKind::point_facet, {z, o, x, Point<3>(2 * x)}).distance, 1, 1e-15);  // on a line
  EXPECT_NEAR(gap_of<3>(PairKind::point_facet, {z, o, o, o}).distance, 1, 1e-15);
  EXPECT_NEAR(gap_of<3>(PairKind::edge_edge, {z, Point<3>(z + x), o, x}).distance, 1, 1e-15);  // parallel
  EXPECT_NEAR(gap_of<3>(PairKind::edge_edge, {o, x, Point<3>(3 * x), Point<3>(5 * x)}).distance, 2, 1e-15);
  EXPECT_EQ(gap_of<3>(PairKind::edge_edge, {o, x, Point<3>(0.5 * x), Point<3>(0.5 * x + z)}).distance, 0);
}

// Whatever the motion: along the free part the facets never come as near as to touch. Some must meet, and are stopped.
template <int Dim>
void never_passes() {
  const Points<Dim> points = random_points<Dim>(8000, 5), motions = random_points<Dim>(8000, 6, 3);
  int stopped = 0;
  for (std::size_t n = 0; n + 4 < points.size(); n += 4)
    for (const PairKind kind : kinds<Dim>()) {
      const PairPoints<Dim> places = pair_at(points, n), motion = pair_at(motions, n);
      const double part = step_limit<Dim>(kind, places, motion), start = gap_of<Dim>(kind, places).distance;
      stopped += part < 1 ? 1 : 0;
      ASSERT_GE(part, 0);
      for (int k = 0; k <= 200; ++k) {
        PairPoints<Dim> then = places;
        for (std::size_t i = 0; i < then.size(); ++i) then[i] += part * k / 200 * motion[i];
        EXPECT_GE(gap_of<Dim>(kind, then).distance, (k < 200 ? 0.00999 : 0.0999) * start);
      }
    }
  EXPECT_GT(stopped, 100);
}

TEST(FreePart, NeverLetsFacetsPass) {
  never_passes<2>();
  never_passes<3>();
}

TEST(FreePart, LetsPassWhatIsFree) {
  const Point<3> o = Point<3>::Zero(), x = Point<3>::UnitX(), y = Point<3>::UnitY(), z = Point<3>::UnitZ();
  const PairPoints<3> places{Point<3>(0.2 * x + 0.2 * y + 0.1 * z), o, x, y};
  const Point<3> far = 100 * (x + z);
  EXPECT_EQ(step_limit<3>(PairKind::point_facet, places, {far, far, far, far}), 1);  // all alike
  EXPECT_EQ(step_limit<3>(PairKind::point_facet, places, {z, o, o, o}), 1);
  EXPECT_NEAR(step_limit<3>(PairKind::point_facet, places, {Point<3>(-z), o, o, o}), 0.09, 2e-3);
}

TEST(BarrierFunction, HasTheDerivativesThatItGives) {
  constexpr double e = 1e-5;
  for (double s = 0.02; s < 1.2; s += 0.01) {
    const BarrierValue b = barrier(s), more = barrier(s + e), less = barrier(s - e);
    EXPECT_NEAR((more.value - less.value) / (2 * e), b.first, 1e-4 * (1 + std::abs(b.first)));
    EXPECT_NEAR((more.first - less.first) / (2 * e), b.second, 1e-3 * (1 + b.second));
    EXPECT_GE(b.second, 0);
    EXPECT_LE(b.first, 0);
  }
}

TEST(Mollifier, HasTheGradientThatItGives) {
  const Points<3> points = random_points<3>(400, 7), directions = random_points<3>(400, 8);
  constexpr double e = 1e-6;
  for (std::size_t n = 0; n + 4 < points.size(); n += 4) {
    const PairPoints<3> places = pair_at(points, n);
    PairPoints<3> more = places, less = places;
    double slope = 0;
    const Mollifier m = mollifier(places, 2);
    for (std::size_t i = 0; i < 4; ++i) {
      more[i] += e * directions[n + i];
      less[i] -= e * directions[n + i];
      slope += m.gradient[i].dot(directions[n + i]);
    }
    EXPECT_NEAR((mollifier(more, 2).value - mollifier(less, 2).value) / (2 * e), slope, 1e-5);
  }
}

}  // namespace
}  // namespace washfsi::test
