// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/profile.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "support/linear_flow.hpp"
#include "support/option_database.hpp"
#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

// The lines of a profile's file.
std::vector<std::string> written(const Profile<2>& profile) {
  const ScratchFolder folder;
  const LinearFlow flow;
  profile.write(flow.grid, flow.boundary, flow.velocity, flow.pressure, 0, folder.path());
  return folder.lines("profiles/" + profile.name + ".csv");
}

// The numbers in a line.
std::vector<double> numbers_in(const std::string& line) {
  std::vector<double> numbers;
  for (const std::string& word : split(line, ',')) numbers.push_back(std::strtod(word.c_str(), nullptr));
  return numbers;
}

// From wall to wall. Beyond the middle of the last cell the pressure is that of the cell.
TEST(Profile, SamplesALinearFlowExactlyUpToTheWalls) {
  const auto lines = written({"mid", {0.5, 0}, {0.5, 1}, 5});
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_EQ(lines[0], "x,y,u,v,p");
  EXPECT_EQ(lines[1], "# m,m,m/s,m/s,Pa");
  const double half_cell = 0.5 / 6;
  for (std::size_t n = 0; n < 5; ++n) {
    const std::vector<double> row = numbers_in(lines[n + 2]);
    ASSERT_EQ(row.size(), 5U);
    const Point<2> place(0.5, 0.25 * static_cast<double>(n));
    const Point<2> velocity = LinearFlow::velocity_at(place);
    const double height = std::clamp(place[1], half_cell, 1 - half_cell);
    const std::vector<double> expected{place[0], place[1], velocity[0], velocity[1],
                                       LinearFlow::pressure_at({place[0], height})};
    for (std::size_t c = 0; c < 5; ++c) EXPECT_NEAR(row[c], expected[c], 1e-13) << "point " << n << ", column " << c;
  }
}

TEST(Profile, OfOnePointIsItsFirst) {
  const auto lines = written({"gauge", {0.25, 0.75}, {0.9, 0.9}, 1});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NEAR(numbers_in(lines[2])[0], 0.25, 1e-15);
  EXPECT_NEAR(numbers_in(lines[2])[2], 0.75, 1e-13);
}

std::vector<Profile<2>> profiles_in(const std::string& text) {
  const OptionDatabase database(text);
  Options options(PETSC_COMM_WORLD);
  auto profiles = profiles_from_options<2>(options, {0, 0}, {1, 0.5});
  options.reject_unread();
  return profiles;
}

TEST(ProfileOptions, GiveALineForEachName) {
  const auto profiles = profiles_in("-profiles a,b -a_from 0,0 -a_to 1,0.5 -b_from 0.5,0 -b_to 0.5,0.25 -b_points 7");
  ASSERT_EQ(profiles.size(), 2U);
  EXPECT_EQ(profiles[0].name, "a");
  EXPECT_EQ(profiles[0].to, Point<2>(1, 0.5));
  EXPECT_EQ(profiles[1].from, Point<2>(0.5, 0));
  EXPECT_EQ(profiles[1].points, 7);
  EXPECT_TRUE(profiles_in("").empty());
}

TEST(ProfileOptions, AreRefusedWithOneLine) {
  const std::vector<std::pair<std::string, std::string>> refused{
      {"-profiles a -a_to 1,0", "-a_from is missing"},
      {"-profiles a -a_from 1,0", "-a_to is missing"},
      {"-profiles a -a_from 0,0 -a_to 1,0.6", "-a_from, -a_to: the line leaves the grid"},
      {"-profiles a -a_from -0.1,0 -a_to 1,0", "-a_from, -a_to: the line leaves the grid"},
      {"-profiles a -a_from 0,0,0 -a_to 1,0", "-a_from 0,0,0: must be 2 numbers"},
      {"-profiles a -a_from 0,0 -a_to 1,0 -a_points 0", "-a_points 0: must be a whole number from 1 to 1000000"},
      {"-profiles a -a_from 0,0 -a_to 1,0 -a_points 2.5", "-a_points 2.5: must be a whole number"},
      {"-profiles a,a", "-profiles a,a: must be different names"},
      {"-profiles grid", "-profiles grid: this name is taken"},
      {"-a_from 0,0", "-a_from 0,0: no part of this run reads this option"},
  };
  expect_refusals<InputError>(profiles_in, refused);
}

}  // namespace
}  // namespace washfsi::test
