// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/cloths.hpp"

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

std::vector<ClothGroup> two_groups(const std::string& model) {
  ClothGroup large, small;
  large.name = "large";
  large.count = 2;
  large.markers = 11;
  small.name = "small";
  small.count = 3;
  small.markers = 4;
  large.model = small.model = model;
  large.fibre = small.fibre = {.spacing = 0.1, .ke = 50, .kb = 0.02, .damping = 0.1, .thickness = 1e-3};
  return {large, small};
}

// The distributed forces, stresses and energies against those of each whole piece.
void expect_same_as_undistributed(const std::string& model) {
  const Cloths<2> all(PETSC_COMM_SELF, two_groups(model)), mine(PETSC_COMM_WORLD, two_groups(model));
  ASSERT_EQ(all.marker_count(), 34);
  const Points<2> x = crumpled_fibre<2>(34, 0.1, 11), u = random_points<2>(34, 12);
  const auto part = [&](const Points<2>& values) {
    return Points<2>(values.begin() + mine.begin(), values.begin() + mine.end());
  };
  const Points<2> whole = all.elastic_forces(x, u), forces = mine.elastic_forces(part(x), part(u));
  const std::vector<double> whole_stress = all.stresses(x), stress = mine.stresses(part(x));
  for (std::size_t m = 0; m < mine.owned(); ++m) {
    const std::size_t global = m + static_cast<std::size_t>(mine.begin());
    EXPECT_EQ(forces[m], whole[global]);
    EXPECT_EQ(stress[m], whole_stress[global]);
  }
  const std::vector<double> energies = mine.elastic_energies(part(x)), whole_energies = all.elastic_energies(x);
  for (std::size_t g = 0; g < 2; ++g) EXPECT_NEAR(energies[g], whole_energies[g], 1e-12 * whole_energies[g]);
}

TEST(Cloths, EnergyFormDoesNotDependOnTheDistribution) {
  expect_same_as_undistributed("energy");
}
TEST(Cloths, LoveFormDoesNotDependOnTheDistribution) {
  expect_same_as_undistributed("love");
}

TEST(Cloths, MassesAndLengthsAddUp) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, two_groups("energy"));
  double mass = 0, length = 0;
  for (const double m : cloths.marker_masses()) mass += m;
  for (const double l : cloths.marker_lengths()) length += l;
  EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, length), 3.4, 1e-12);
  EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, mass), 3.4 * 0.093, 1e-12);
}

}  // namespace
}  // namespace washfsi::test
