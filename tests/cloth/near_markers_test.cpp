// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/near_markers.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/cloth/facets.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

constexpr double marker_spacing = 0.02;

/// Small cloths all over a box of one metre, each flat, or in the plane straight, along a direction of its own.
template <int Dim>
class Scattered {
 public:
  explicit Scattered(const PeriodicSpace<Dim>& space) : space_(space), cloths_(PETSC_COMM_WORLD, {group()}) {
    const auto pieces = cloths_.pieces().size();
    const Points<Dim> middles = random_points<Dim>(pieces, 31, 0.5), ways = random_points<Dim>(pieces, 32);
    for (std::size_t p = 0; p < pieces; ++p) {
      const Point<Dim> along = marker_spacing * ways[p].normalized();
      Point<Dim> beside = Point<Dim>::Zero();
      if constexpr (Dim == 3) beside = marker_spacing * along.cross(Point<3>::UnitX()).normalized();
      for (std::size_t k = 0; k < static_cast<std::size_t>(cloths_.pieces()[p].count); ++k) {
        const std::size_t width = group().sheet.width;
        all_.push_back(middles[p] + static_cast<double>(k / width) * along + static_cast<double>(k % width) * beside);
      }
    }
  }

  const Cloths<Dim>& cloths() const { return cloths_; }
  const PeriodicSpace<Dim>& space() const { return space_; }
  const Points<Dim>& all() const { return all_; }
  Points<Dim> own(const Points<Dim>& values) const {
    return {values.begin() + cloths_.begin(), values.begin() + cloths_.end()};
  }
  std::vector<double> reaches() const { return std::vector<double>(cloths_.owned(), 0.3 * marker_spacing); }
  bool is_own(std::size_t number) const {
    const auto marker = static_cast<PetscInt>(number);
    return marker >= cloths_.begin() && marker < cloths_.end();
  }
  /// How far apart two markers may come: less than that, along no axis farther.
  double apart(std::size_t a, std::size_t b) const {
    Point<Dim> way = all_[a] - all_[b];
    for (int d = 0; d < Dim; ++d)
      if (space_.periodic[d]) way[d] -= space_.length[d] * std::round(way[d] / space_.length[d]);
    return way.cwiseAbs().maxCoeff() - 0.6 * marker_spacing;
  }

 private:
  static ClothGroup<Dim> group() {
    ClothGroup<Dim> group;
    group.name = "patch";
    group.count = 40;
    group.markers = {5, Dim == 3 ? 4 : 1};
    group.sheet.width = Dim == 3 ? 4 : 1;
    group.sheet.ds = marker_spacing;
    group.sheet.dr = Dim == 3 ? marker_spacing : 1;
    return group;
  }

  PeriodicSpace<Dim> space_;
  Cloths<Dim> cloths_;
  Points<Dim> all_;
};

template <int Dim>
struct Near : NearMarkers<Dim> {
  Near(const Scattered<Dim>& scattered, double distance) : NearMarkers<Dim>(scattered.cloths(), scattered.space()) {
    this->choose(scattered.own(scattered.all()), scattered.reaches(), distance);
  }
};

template <int Dim>
PeriodicSpace<Dim> box(bool is_periodic) {
  PeriodicSpace<Dim> space{Point<Dim>::Constant(-0.5), Point<Dim>::Ones(), {}};
  space.periodic.fill(is_periodic);
  return space;
}

template <int N>
struct Dimension {
  static constexpr int value = N;
};
template <class T>
class NearMarkersTest : public testing::Test {};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(NearMarkersTest, Dimensions, );

// By all pairs of markers; and facets with a marker of this rank are known whole.
TYPED_TEST(NearMarkersTest, AreAllThatMayComeNear) {
  constexpr int Dim = TypeParam::value;
  constexpr double distance = 1.5 * marker_spacing;
  for (const bool is_periodic : {false, true}) {
    const Scattered<Dim> scattered(box<Dim>(is_periodic));
    const Near<Dim> near(scattered, distance);
    const auto knows = [&](std::size_t number) { return std::ranges::binary_search(near.numbers(), number); };
    for (std::size_t a = 0; a < scattered.all().size(); ++a)
      for (std::size_t b = 0; b < scattered.all().size(); ++b)
        EXPECT_TRUE(knows(b) || !scattered.is_own(a) || scattered.apart(a, b) >= distance) << a << " and " << b;
    const Facets<Dim> facets(scattered.cloths(), near);
    double own = 0;
    for (const auto& face : facets.faces) own += near.owns(face[0]) ? 1 : 0;
    const double of_cloth = Dim == 3 ? 2 * 4 * 3 : 4;
    EXPECT_EQ(ordered_sum(PETSC_COMM_WORLD, own), 40 * of_cloth);
  }
}

// A rank knows its own and what is round them, not all that there is.
TYPED_TEST(NearMarkersTest, AreFewOfAll) {
  constexpr int Dim = TypeParam::value;
  const Scattered<Dim> scattered(box<Dim>(false));
  const double others =
      static_cast<double>(Near<Dim>(scattered, 0.1 * marker_spacing).size() - scattered.cloths().owned());
  EXPECT_LT(others, 0.5 * static_cast<double>(scattered.all().size()));
  EXPECT_EQ(others > 0, ranks_of(PETSC_COMM_WORLD) > 1);
}

TYPED_TEST(NearMarkersTest, HaveTheValuesOfTheirOwners) {
  constexpr int Dim = TypeParam::value;
  const Scattered<Dim> scattered(box<Dim>(true));
  const Near<Dim> near(scattered, 2 * marker_spacing);
  const Points<Dim> places = near.values(scattered.own(scattered.all()));
  std::vector<double> firsts;
  for (const auto& place : scattered.own(scattered.all())) firsts.push_back(place[0]);
  const std::vector<double> numbers = near.values(firsts);
  for (std::size_t m = 0; m < near.size(); ++m) {
    EXPECT_EQ(places[m], scattered.all()[near.numbers()[m]]);
    EXPECT_EQ(numbers[m], scattered.all()[near.numbers()[m]][0]);
    EXPECT_EQ(near.place_of(near.numbers()[m]), m);
    EXPECT_EQ(near.owns(m), scattered.is_own(near.numbers()[m]));
  }
}

// Each rank gives one, or its own number, to all that it knows.
TYPED_TEST(NearMarkersTest, GiveTheirOwnersSumsAndTheLeast) {
  constexpr int Dim = TypeParam::value;
  const Scattered<Dim> scattered(box<Dim>(false));
  const Near<Dim> near(scattered, 4 * marker_spacing);
  const double rank = rank_of(PETSC_COMM_WORLD);
  const Points<Dim> sums = near.sums(Points<Dim>(near.size(), Point<Dim>::Ones()));
  const std::vector<double> least = near.least(std::vector<double>(near.size(), rank));
  double knowing = 0;  // markers, once for each rank that does
  for (std::size_t m = 0; m < sums.size(); ++m) {
    EXPECT_EQ(sums[m], Point<Dim>(Point<Dim>::Constant(sums[m][0])));
    EXPECT_LE(least[m], rank);
    EXPECT_EQ(least[m] < rank && sums[m][0] == 1, false) << "another rank knows it";
    knowing += sums[m][0];
  }
  EXPECT_EQ(ordered_sum(PETSC_COMM_WORLD, knowing), ordered_sum(PETSC_COMM_WORLD, static_cast<double>(near.size())));
}

// Chosen anew at other places, and with those before.
TYPED_TEST(NearMarkersTest, KeepWhatTheyKnewIfAsked) {
  constexpr int Dim = TypeParam::value;
  const Scattered<Dim> scattered(box<Dim>(false));
  Near<Dim> near(scattered, 4 * marker_spacing);
  const std::vector<std::size_t> before = near.numbers();
  near.choose(scattered.own(scattered.all()), scattered.reaches(), 0, Before::keep);
  EXPECT_EQ(near.numbers(), before);
  const bool changes = near.choose(scattered.own(scattered.all()), scattered.reaches(), 0);
  EXPECT_EQ(changes, ranks_of(PETSC_COMM_WORLD) > 1);
  EXPECT_EQ(near.numbers(), Near<Dim>(scattered, 0).numbers());
}

}  // namespace
}  // namespace washfsi::test
