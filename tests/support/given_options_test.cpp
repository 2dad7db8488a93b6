// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/given_options.hpp"

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

GivenOptions all_of(const std::vector<GivenOption>& list) {
  GivenOptions given;
  for (const GivenOption& option : list) given.add(option);
  return given;
}

TEST(GivenOptions, HaveNamesInAnyCaseOfWhichTheLastCounts) {
  const GivenOptions given = all_of({{"-Time_End", "1", true, "a.opts", true}, {"--time_end", "2", true, ""}});
  EXPECT_TRUE(given.on_command_line("time_end"));
  EXPECT_TRUE(given.on_command_line("TIME_END"));
  EXPECT_FALSE(given.is_recorded("time_end"));
  EXPECT_FALSE(given.on_command_line("time_step"));
  EXPECT_EQ(given.value("Time_end"), "2");
  EXPECT_EQ(given.value("time_step"), "");
}

TEST(GivenOptions, LackAValueUnlessOneIsGivenEvenAnEmptyOne) {
  const GivenOptions given = all_of({{"-check", "", false, ""}, {"-drum_stl", "", true, ""}});
  EXPECT_TRUE(given.lacks_value("check"));
  EXPECT_FALSE(given.lacks_value("drum_stl"));
  EXPECT_FALSE(given.lacks_value("restart"));
}

TEST(GivenOptions, NameFilesBesideTheFileInWhichTheyStand) {
  const GivenOptions given = all_of({{"-drum_stl", "drum.stl", true, "cases/wash/wash.opts"},
                                     {"-vane_stl", "/parts/vane.stl", true, "cases/wash/wash.opts"},
                                     {"-restart", "out/checkpoint.h5", true, ""}});
  EXPECT_EQ(given.resolve("drum_stl", "drum.stl"), "cases/wash/drum.stl");
  EXPECT_EQ(given.resolve("vane_stl", "/parts/vane.stl"), "/parts/vane.stl");
  EXPECT_EQ(given.resolve("restart", "out/checkpoint.h5"), "out/checkpoint.h5");
  EXPECT_EQ(given.resolve("drum_stl", ""), "");
}

TEST(GivenOptions, TellTheNamesThatALaterListHasDropped) {
  const GivenOptions given = all_of({{"-cloths", "towel,sock,towel", true, "a.opts"},
                                     {"-bodies", "drum", true, "a.opts"},
                                     {"-cloths", "towel,shirt", true, ""}});
  EXPECT_EQ(given.dropped("cloths", {"towel", "shirt"}), std::vector<std::string>{"sock"});
  EXPECT_EQ(given.dropped("cloths", {}), (std::vector<std::string>{"towel", "sock", "shirt"}));
}

TEST(GivenOptions, AreOverriddenByAnotherValueOrByAnotherFilesGroup) {
  const GivenOptions given = all_of({{"-towel_ke", "50", true, "a.opts"},
                                     {"-gravity", "0,-9.81", true, "a.opts"},
                                     {"-gravity", "0,-9.81", true, ""},
                                     {"-contact", "none", true, "a.opts"},
                                     {"-contact", "barrier", true, ""},
                                     {"-cloths_ke", "80", true, ""}});
  EXPECT_TRUE(given.overridden("contact", "contact_"));
  EXPECT_FALSE(given.overridden("gravity", "gravity_"));  // by the same value
  EXPECT_TRUE(given.overridden("cloths_ke", "towel_"));
  EXPECT_FALSE(given.overridden("cloths_ke", "sock_"));
  EXPECT_FALSE(given.overridden("rest_speed", "towel_"));
}

TEST(GivenOptions, KnowWhatALaterPlaceGives) {
  const GivenOptions given = all_of(
      {{"-gravity", "0,-9.81", true, "a.opts"}, {"-contact", "none", true, "a.opts"}, {"-fluid", "none", true, ""}});
  EXPECT_TRUE(given.given_elsewhere_after("gravity", "fluid"));
  EXPECT_FALSE(given.given_elsewhere_after("gravity", "contact"));  // the same file
  EXPECT_FALSE(given.given_elsewhere_after("fluid", "gravity"));
  EXPECT_FALSE(given.given_elsewhere_after("gravity", "bodies"));
}

TEST(GivenOptions, ArriveOnOtherRanksAsTheyAre) {
  const GivenOptions given = all_of(
      {{"-drum_stl", "my drum#1.stl", true, "a.opts", true}, {"-check", "", false, ""}, {"-case_name", "", true, ""}});
  const GivenOptions arrived = GivenOptions::unpacked(given.packed());
  ASSERT_EQ(arrived.all().size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) {
    const GivenOption &sent = given.all()[n], &got = arrived.all()[n];
    EXPECT_EQ(got.word, sent.word);
    EXPECT_EQ(got.value, sent.value);
    EXPECT_EQ(got.has_value, sent.has_value);
    EXPECT_EQ(got.file, sent.file);
    EXPECT_EQ(got.recorded, sent.recorded);
  }
}

}  // namespace
}  // namespace washfsi::test
