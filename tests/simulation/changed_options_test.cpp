// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/changed_options.hpp"

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

TEST(ChangedOptions, AreToldWithTheirOldAndNewValues) {
  EXPECT_EQ(changed_options("-fluid_density 1000\n-towel_ke 50\n", "-towel_ke 80\n-fluid_density 1000\n"),
            std::vector<std::string>{"note: -towel_ke was 50, is now 80"});
}

TEST(ChangedOptions, AreThoseThatOnlyOneRunHasToo) {
  EXPECT_EQ(changed_options("-contact none\n", "-gravity 0,-9.81\n"),
            (std::vector<std::string>{"note: -contact was none, is now not given",
                                      "note: -gravity was not given, is now 0,-9.81"}));
}

// One cannot tell from what a checkpoint of an earlier version has not.
TEST(ChangedOptions, AreNoneWhereTheOldOnesAreNotKnown) {
  EXPECT_TRUE(changed_options("", "-gravity 0,-9.81\n").empty());
}

TEST(ChangedOptions, MayHaveBlanksInTheirValues) {
  EXPECT_EQ(changed_options("-drum_stl \"my drum.stl\"\n", "-drum_stl \"my drum2.stl\"\n").size(), 1U);
  EXPECT_TRUE(changed_options("-drum_stl \"my drum.stl\"\n", "-drum_stl \"my drum.stl\"\n").empty());
}

TEST(CaseOptions, AreNotChangedByALongerRunInAnotherFolder) {
  const std::string of_case = "-fluid_density 1000\n-gravity 0,-9.81\n";
  const std::string before =
      "# every option\n" + of_case + "-time_end 1\n-max_steps 0\n-output_dir out\n-case_name a\n";
  const std::string now =
      of_case +
      "-time_end 20\n-max_steps 7\n-output_dir more\n-case_name b\n-restart out/checkpoint.h5\n"
      "-history_interval 0.1\n-output_interval 0.5\n-checkpoint_interval 2\n-check true\n-strict\n-log_view\n";
  EXPECT_EQ(case_options(before), of_case);
  EXPECT_EQ(case_options(now), of_case);
}

TEST(CaseOptions, AreChangedByTheLengthOfSteps) {
  EXPECT_NE(case_options("-time_step 0.1\n-time_end 1\n"), case_options("-time_step 0.2\n-time_end 1\n"));
}

TEST(Repeatable, SaysFromWhatTheRunWentOnWithoutDoingSo) {
  EXPECT_EQ(repeatable("# head\n-gravity 0,-9.81\n-restart out/checkpoint.h5\n-restarts 3\n"),
            "# head\n-gravity 0,-9.81\n# the run went on from out/checkpoint.h5\n-restarts 3\n");
}

}  // namespace
}  // namespace washfsi::test
