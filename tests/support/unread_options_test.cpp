// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/unread_options.hpp"

#include <gtest/gtest.h>

#include "support/option_database.hpp"
#include "support/refusal.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

using Notes = std::vector<std::string>;

// A run that has read a density, and has left out the options of a sock.
OptionRegister read_register() {
  OptionRegister known;
  known.declared.add({"Fluid", "fluid_density", "1000", "kg/m3", "", ""});
  known.left_out.leave_out("-cloths does not name sock any more", [&] {
    for (const char* name : {"sock_ke", "sock_kb"}) known.left_out.add(name);
  });
  known.answers["viscosity"] = "is -fluid_viscosity now";
  return known;
}

Notes notes_of(const std::string& text) {
  const OptionDatabase database(text);
  return reject_unread_options(read_register());
}

TEST(UnreadOptions, AreRefusedWithTheNameThatWasMeant) {
  const std::vector<std::pair<std::string, std::string>> refused{
      {"-fluid_densty 900", "-fluid_densty 900: no part of this run reads this option; did you mean -fluid_density?"},
      {"-sock_kee 5", "did you mean -sock_ke?"},
      {"-qqq", "-qqq: no part of this run reads this option (-help lists all)"},
      {"-viscosity 1", "-viscosity 1: is -fluid_viscosity now"},
      {"-ksp_rtol 1e-9", "-ksp_rtol 1e-9: no solver is without a prefix; say -pressure_ksp_rtol"},
  };
  expect_refusals<InputError>(notes_of, refused);
}

TEST(UnreadOptions, MayBePetscsOwn) {
  EXPECT_EQ(notes_of("-fluid_density 900 -log_view -pressure_ksp_converged_reason"), Notes{});
}

TEST(UnreadOptions, AreToldTogetherWhereTheirPartIsSwitchedOff) {
  EXPECT_EQ(notes_of("-sock_ke 5 -sock_kb 7"),
            Notes{"warning: -cloths does not name sock any more, so without effect: -sock_kb -sock_ke"});
}

// What the program itself has written, in resolved.opts or by a preset, is no wish of the user.
TEST(UnreadOptions, AreNoMatterWhereTheProgramWroteThem) {
  OptionRegister known = read_register();
  known.given.add({"-sock_ke", "5", true, "resolved.opts", true});
  const OptionDatabase database("-sock_ke 5");
  EXPECT_EQ(reject_unread_options(known), Notes{});
}

// Who switches water off on the command line knows that a file has a density.
TEST(UnreadOptions, AreNoWarningWhereALaterPlaceMakesThemIdle) {
  for (const bool on_line : {true, false}) {
    OptionRegister known = read_register();
    known.declared.set_given_as("fluid_density", "fluid_density");
    known.declared.mark_idle("-fluid is none", {"fluid_density"});
    known.given.add({"-fluid_density", "1000", true, "a.opts"});
    known.given.add({"-fluid", "none", true, on_line ? "" : "a.opts"});
    const OptionDatabase database("");
    const std::string kind = on_line ? "note" : "warning";
    EXPECT_EQ(reject_unread_options(known), Notes{kind + ": -fluid is none, so without effect: -fluid_density"});
  }
}

}  // namespace
}  // namespace washfsi::test
