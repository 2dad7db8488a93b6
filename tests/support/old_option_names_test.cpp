// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/old_option_names.hpp"

#include <gtest/gtest.h>

#include "support/option_database.hpp"
#include "support/refusal.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/petsc_options.hpp"

namespace washfsi::test {
namespace {

using Database = std::map<std::string, std::string>;

TEST(OldOptionNames, StandForThePresentOnes) {
  const OptionDatabase options("-cloth_coupling explicit -gravity 0,-9.81");
  OldOptionNames names;
  EXPECT_TRUE(names.replace("cloth_coupling", "coupling_scheme", {}));
  EXPECT_FALSE(names.replace("cloth_sweeps", "coupling_sweeps", {}));  // is not given
  EXPECT_EQ(options_in_database(), (Database{{"coupling_scheme", "explicit"}, {"gravity", "0,-9.81"}}));
  EXPECT_EQ(names.as_given("coupling_scheme"), "cloth_coupling");
  EXPECT_EQ(names.as_given("coupling_sweeps"), "coupling_sweeps");
  EXPECT_EQ(names.all().size(), 2U);
}

// PETSc keeps a name as it was written, and finds it in any case.
TEST(OldOptionNames, AreTheSameInCapitals) {
  const OptionDatabase options("-Cloth_Coupling explicit");
  OldOptionNames names;
  EXPECT_TRUE(names.replace("cloth_coupling", "coupling_scheme", {}));
  EXPECT_EQ(petsc::option_value("", "-coupling_scheme", ""), "explicit");
}

TEST(OldOptionNames, AreRefusedBesideThePresentOnesInOnePlace) {
  const OptionDatabase options("-old 1 -new 2");
  for (const char* file : {"", "a.opts"}) {
    GivenOptions given;
    given.add({"-old", "1", true, file});
    given.add({"-new", "2", true, file});
    OldOptionNames names;
    expect_refusal<InputError>([&] { (void)names.replace("old", "new", given); },
                               "-old: is the old name of -new, which is given too; leave one out");
  }
}

// Whichever of the names stands there.
TEST(OldOptionNames, OnTheCommandLineCountMoreThanThePresentOnesInAFile) {
  for (const bool old_on_line : {true, false}) {
    const OptionDatabase options("-old 1 -new 2");
    GivenOptions given;
    given.add({"-old", "1", true, old_on_line ? "" : "a.opts"});
    given.add({"-new", "2", true, old_on_line ? "a.opts" : ""});
    OldOptionNames names;
    EXPECT_EQ(names.replace("old", "new", given), old_on_line);
    EXPECT_EQ(options_in_database(), (Database{{"new", old_on_line ? "1" : "2"}}));
    EXPECT_EQ(names.as_given("new"), old_on_line ? "old" : "new");
  }
}

}  // namespace
}  // namespace washfsi::test
