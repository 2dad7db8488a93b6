// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/report_lines.hpp"

#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"

namespace washfsi::test {
namespace {

TEST(ReportLines, TellStepsEndAndTheBoundOfTheCoupling) {
  constexpr double none = std::numeric_limits<double>::infinity();
  EXPECT_EQ(time_line(0.001, 2, 0.0025, true), "  time      step 0.001 s, end 2 s, bound of the coupling 0.0025 s");
  EXPECT_EQ(time_line(0.001, 2, none, true), "  time      step 0.001 s, end 2 s, which the coupling does not bound");
  EXPECT_EQ(time_line(0.001, 2, none, false), "  time      step 0.001 s, end 2 s");
}

// What a run to this time says of cycles of this period.
std::vector<std::string> demonstration(double period, double end) {
  QuantityList quantities;
  const Cycles cycles(quantities, period, "cycle");
  return demonstration_lines(cycles, end);
}

TEST(ReportLines, CallARunOfFewerThanTwoCyclesADemonstration) {
  ASSERT_EQ(demonstration(2, 1.9).size(), 1U);
  EXPECT_NE(demonstration(2, 1.9)[0].find("not one complete: a demonstration"), std::string::npos);
  ASSERT_EQ(demonstration(2, 2).size(), 1U);
  EXPECT_NE(demonstration(2, 2)[0].find("one, which is start-up"), std::string::npos);
  EXPECT_EQ(demonstration(2, 3.9).size(), 1U);
  EXPECT_TRUE(demonstration(2, 4).empty());
  EXPECT_TRUE(demonstration(0, 4).empty());  // no cycles
}

TEST(ReportLines, AdviseAnEndThatCompletesThreeCycles) {
  for (const double period : {2.0, 0.1234567, 123.456, 1.0 / 3}) {
    const auto lines = demonstration(period, 0.5 * period);
    ASSERT_EQ(lines.size(), 1U);
    const std::string option = "-time_end ";
    const double end = std::strtod(lines[0].c_str() + lines[0].find(option) + option.size(), nullptr);
    EXPECT_GE(end, 3 * period * (1 - 1e-6));
    EXPECT_LE(end, 3 * period * 1.01);
  }
}

TEST(ReportLines, ShowFindingsThatAreNotOkOrAlwaysShown) {
  const Findings findings{{.name = "gap", .text = "wide", .advice = ""},
                          {.name = "cost", .text = "an hour", .advice = "", .display = Display::always},
                          {.name = "cells", .text = "few", .verdict = Verdict::warn, .advice = "use more"}};
  const auto shown = trust_lines(findings, false);
  ASSERT_EQ(shown.size(), 2U);
  EXPECT_NE(shown[0].find("an hour"), std::string::npos);
  EXPECT_NE(shown[1].find("few"), std::string::npos);
  EXPECT_EQ(trust_lines(findings, true).size(), 3U);
}

TEST(ReportLines, BeginWithCaseGridAndCloth) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
  const auto lines = banner_lines<2>(system->model, "rinse", "explicit");
  ASSERT_EQ(lines.size(), 4U);  // no line on bodies, since there are none
  EXPECT_EQ(lines[0], "washfsi: case rinse, 1 rank");
  EXPECT_EQ(lines[1], "  grid      32 x 32 cells of 0.01 x 0.01 m");
  EXPECT_EQ(lines[2], "  cloth     1 fibre of 20 markers (20 markers), coupled explicit");
}

}  // namespace
}  // namespace washfsi::test
