// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/doubtful_options.hpp"

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"

namespace washfsi::test {
namespace {

// The warnings of a case.
template <int Dim>
std::vector<std::string> doubts(const CaseOptions<Dim>& chosen, const std::vector<Body<Dim>>& bodies = {}) {
  Options options(PETSC_COMM_WORLD);
  warn_of_doubtful_options<Dim>(options, chosen, bodies);
  return options.notes();
}

// In cm/s2, and in g/m2.
TEST(DoubtfulOptions, AreThoseInOtherUnits) {
  CaseOptions<2> chosen = fibre_in_water(0.093, 0);
  chosen.model.gravity = {0, -9.81};
  EXPECT_TRUE(doubts(chosen).empty());
  chosen.model.gravity = {0, -981};
  EXPECT_EQ(doubts(chosen), std::vector<std::string>{"warning: -gravity 0,-981: ten times the earth's and more; it is "
                                                     "in m/s2"});
  chosen.model.gravity = {0, 0};
  chosen.model.cloths[0].excess_mass = 93;
  EXPECT_EQ(doubts(chosen),
            std::vector<std::string>{"warning: -fibre_excess_mass 93: no fabric is so heavy; it is in kg/m2"});
}

TEST(DoubtfulOptions, AreNoneOfACaseInUnitsOfItsOwnOrWithoutWater) {
  CaseOptions<2> chosen = fibre_in_water(93, 0);
  chosen.model.gravity = {0, -981};
  EXPECT_EQ(doubts(chosen).size(), 2U);
  CaseOptions<2> without_water = chosen;
  without_water.model.medium = Medium::none;
  EXPECT_TRUE(doubts(without_water).empty());
  chosen.model.fluid.density = 1;
  EXPECT_TRUE(doubts(chosen).empty());
}

TEST(DoubtfulOptions, AreAnAxisRoundWhichNothingTurns) {
  CaseOptions<3> chosen;
  chosen.measure.phases.count = 4;
  chosen.measure.phases.axis = 0;
  std::vector<Body<3>> bodies(1);
  bodies[0].name = "drum";
  EXPECT_TRUE(doubts(chosen, bodies).empty());  // it rests
  bodies[0].motion.angular_speed = 5;
  EXPECT_EQ(doubts(chosen, bodies),
            std::vector<std::string>{"warning: -statistics_phase_axis x: body drum turns about z"});
  chosen.measure.phases.axis = 2;
  EXPECT_TRUE(doubts(chosen, bodies).empty());
}

TEST(DoubtfulOptions, AreCyclesOfLessThanTenSteps) {
  const CaseOptions<2> chosen = fibre_in_water(0.093, 0);
  const auto system = start_system<2>(PETSC_COMM_WORLD, chosen, {});
  MeasureOptions measure;
  measure.cycle_time = 0.1;
  const Measures<2> measures(*system, measure);
  Options options(PETSC_COMM_WORLD);
  warn_of_short_spans<2>(options, measures, 0.01);  // ten of them
  EXPECT_TRUE(options.notes().empty());
  warn_of_short_spans<2>(options, measures, 0.0101);
  ASSERT_EQ(options.notes().size(), 1U);
  EXPECT_TRUE(options.notes()[0].starts_with("warning: -cycle_time: cycles of 0.1 s are shorter than ten steps"));
}

}  // namespace
}  // namespace washfsi::test
