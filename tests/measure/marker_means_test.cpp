// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/marker_means.hpp"

#include <functional>

#include <gtest/gtest.h>

#include "support/lattice_group.hpp"

namespace washfsi::test {
namespace {

// A value of each of this rank's markers, from its number among all.
std::vector<double> by_number(const Cloths<3>& cloths, const std::function<double(PetscInt)>& value) {
  std::vector<double> values;
  for (std::size_t m = 0; m < cloths.owned(); ++m) values.push_back(value(cloths.number_of(m)));
  return values;
}

// A towel of 3 x 3 markers: on a nodal lattice the middle one has a quarter of the area and a corner a sixteenth.
TEST(MarkerMeans, CountEachMarkerByItsArea) {
  for (const auto lattice : {MarkerLattice::centred, MarkerLattice::nodal}) {
    const bool nodal = lattice == MarkerLattice::nodal;
    const Cloths<3> cloths(PETSC_COMM_WORLD, {lattice_group<3>("towel", 1, {3, 3}, lattice)});
    const MarkerMeans<3> means(cloths);
    const auto of_marker = [&](PetscInt one) {
      return means.of_cloths(by_number(cloths, [&](PetscInt m) { return m == one ? 1.0 : 0.0; })).at(0);
    };
    EXPECT_NEAR(of_marker(4), nodal ? 1.0 / 4 : 1.0 / 9, 1e-15);
    EXPECT_NEAR(of_marker(8), nodal ? 1.0 / 16 : 1.0 / 9, 1e-15);
  }
}

// Two towels with markers 0 to 17 and a belt with 18 to 23.
struct TowelsAndBelt {
  Cloths<3> cloths{PETSC_COMM_WORLD, {lattice_group<3>("towel", 2, {3, 3}), lattice_group<3>("belt", 1, {2, 3})}};
  MarkerMeans<3> means{cloths};
};

TEST(MarkerMeans, AreOfEachClothByItself) {
  const TowelsAndBelt load;
  const auto means = load.means.of_cloths(by_number(load.cloths, [](PetscInt m) { return static_cast<double>(m); }));
  ASSERT_EQ(means.size(), 3U);
  EXPECT_NEAR(means[0], 4, 1e-13);
  EXPECT_NEAR(means[1], 13, 1e-13);
  EXPECT_NEAR(means[2], 20.5, 1e-13);
}

TEST(MarkerMeans, AreOfAllClothsOfAGroupAndOfEachValueOfAMarker) {
  const TowelsAndBelt load;
  std::vector<double> pairs;
  for (const double number : by_number(load.cloths, [](PetscInt m) { return static_cast<double>(m); }))
    pairs.insert(pairs.end(), {number, -2 * number});
  const auto means = load.means.of_groups(pairs, 2);
  ASSERT_EQ(means.size(), 2U);
  for (std::size_t n = 0; n < 2; ++n) {
    ASSERT_EQ(means[n].size(), 2U);
    EXPECT_NEAR(means[n][0], n == 0 ? 8.5 : 20.5, 1e-13);
    EXPECT_NEAR(means[n][1], n == 0 ? -17 : -41, 1e-13);
  }
}

}  // namespace
}  // namespace washfsi::test
