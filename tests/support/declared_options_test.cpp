// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/declared_options.hpp"

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

// An option that the user gave by its own name.
void declare_given(DeclaredOptions& declared, const std::string& name, const std::string& value) {
  declared.add({"block", name, value, "", "", ""});
  declared.set_given_as(name, name);
}

using Reasons = std::map<std::string, std::string>;

TEST(DeclaredOptions, HaveTheValueOfTheirLastDeclarationOrOneThatTheProgramComputed) {
  DeclaredOptions declared;
  declared.require("time_end");
  declared.add({"Run", "time_end", "1", "s", "", ""});
  declared.add({"Contact", "distance", "0.01", "m", "", ""});
  declared.add({"Contact", "distance", "0.02", "m", "", ""});
  EXPECT_EQ(declared.values(), (Reasons{{"time_end", "1"}, {"distance", "0.02"}}));
  declared.record("distance", "0.03");
  EXPECT_EQ(declared.values().at("distance"), "0.03");
  ASSERT_EQ(declared.list().size(), 3U);
  EXPECT_TRUE(declared.list()[0].required);
  EXPECT_FALSE(declared.list()[1].required);
  EXPECT_FALSE(declared.contains("dist"));
}

TEST(DeclaredOptions, AreMarkedAsIdleByWholeNamesOrByTheirStart) {
  DeclaredOptions declared;
  for (const char* name : {"contact", "contact_distance", "contact_pressure", "statistics", "statistics_start"})
    declare_given(declared, name, "1");
  declared.mark_idle("no cloths", {"contact_*", "statistics"});
  declared.mark_idle("another reason", {"contact_pressure"});  // the first counts
  EXPECT_EQ(
      declared.idle_as_given({}),
      (Reasons{{"contact_distance", "no cloths"}, {"contact_pressure", "no cloths"}, {"statistics", "no cloths"}}));
}

TEST(DeclaredOptions, AreNotToldAsIdleIfSwitchedOffOrNotGiven) {
  DeclaredOptions declared;
  const std::vector<std::string> off{"0", "0,0", "0.0", "none", "false", "no", ""};
  for (const std::string& value : off) declare_given(declared, "a_" + value, value);
  declare_given(declared, "a_small", "0,1e-9");
  declared.add({"block", "a_default", "5", "", "", ""});
  declared.mark_idle("nothing", {"a_*"});
  EXPECT_EQ(declared.idle_as_given({}), (Reasons{{"a_small", "nothing"}}));
}

// A run writes all its options, with those that have no effect, so that it can be repeated.
TEST(DeclaredOptions, AreNotToldAsIdleWhereARunHasRecordedThem) {
  DeclaredOptions declared;
  declare_given(declared, "gravity", "0,-9.81");
  declared.mark_idle("no cloths", {"gravity"});
  GivenOptions recorded;
  recorded.add({"-gravity", "0,-9.81", true, "resolved.opts", true});
  EXPECT_TRUE(declared.idle_as_given(recorded).empty());
  recorded.add({"-gravity", "0,-9.81", true, ""});
  EXPECT_EQ(declared.idle_as_given(recorded), (Reasons{{"gravity", "no cloths"}}));
}

TEST(DeclaredOptions, OfAllGroupsAreIdleOnlyIfTheyAreInEach) {
  DeclaredOptions declared;
  for (const char* name : {"sock_seed", "towel_seed"}) {
    declared.add({"block", name, "7", "", "", ""});
    declared.set_given_as(name, "cloths_seed");
  }
  declared.mark_idle("nothing is random", {"sock_seed"});
  EXPECT_TRUE(declared.idle_as_given({}).empty());
  declared.mark_idle("nothing is random", {"towel_seed"});
  EXPECT_EQ(declared.idle_as_given({}), (Reasons{{"cloths_seed", "nothing is random"}}));
}

}  // namespace
}  // namespace washfsi::test
