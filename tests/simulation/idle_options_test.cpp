// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/idle_options.hpp"

#include <gtest/gtest.h>

#include "support/option_database.hpp"

namespace washfsi::test {
namespace {

// The notes on the options of a case.
std::vector<std::string> notes_on(const std::string& text) {
  const OptionDatabase database("-grid_cells 16,16 " + text);
  Options options(PETSC_COMM_WORLD);
  const auto chosen = CaseOptions<2>::from_options(options);
  const auto bodies = bodies_from_options<2>(options, chosen.model.grid.shape.spacing().minCoeff());
  mark_idle_options<2>(options, chosen, bodies);
  options.reject_unread();
  return options.notes();
}

using Notes = std::vector<std::string>;

TEST(IdleOptions, AreToldWithTheirReason) {
  EXPECT_EQ(notes_on("-gravity 0,-9.81"), Notes{"warning: -cloths names none, so without effect: -gravity"});
  EXPECT_EQ(notes_on("-body_balance"), Notes{"warning: -bodies names none, so without effect: -body_balance"});
  EXPECT_EQ(notes_on("-cloths towel -cloth_drag 3"), Notes{"warning: -fluid is water, so without effect: -cloth_drag"});
  EXPECT_EQ(notes_on("-cloths towel -fluid none -fluid_density 900"),
            Notes{"warning: -fluid is none, so without effect: -fluid_density"});
  EXPECT_EQ(notes_on("-cloths towel -towel_excess_mass 0 -gravity 0,-9.81"),
            Notes{"warning: no cloth has an excess mass, so without effect: -gravity"});
  EXPECT_EQ(notes_on("-cloths towel -towel_seed 7"),
            Notes{"warning: nothing of towel is random, so without effect: -towel_seed"});
}

TEST(IdleOptions, AreThoseOfOtherCouplings) {
  EXPECT_EQ(notes_on("-cloths towel -coupling_scheme explicit -coupling_tolerance 1e-4 -coupling_sweeps 3").size(), 1U);
  EXPECT_EQ(notes_on("-cloths towel -coupling_scheme semi_implicit -coupling_time_scheme backward_euler"),
            Notes{"warning: -coupling_scheme is semi_implicit, so without effect: -coupling_time_scheme"});
  EXPECT_EQ(notes_on("-cloths towel -coupling_scheme implicit -coupling_order 2"),
            Notes{"warning: -coupling_scheme is implicit, so without effect: -coupling_order"});
}

TEST(IdleOptions, AreNotToldWhereTheyHaveAnEffect) {
  EXPECT_EQ(notes_on("-cloths towel -gravity 0,-9.81 -coupling_tolerance 1e-4 -coupling_sweeps 3"), Notes{});
  EXPECT_EQ(notes_on("-cloths towel -coupling_scheme implicit -coupling_time_scheme backward_euler"), Notes{});
  EXPECT_EQ(notes_on("-cloths towel -fluid none -cloth_drag 3"), Notes{});
  EXPECT_EQ(notes_on("-fluid_density 900 -wall_model none"), Notes{});
}

TEST(IdleOptions, AreNotToldWhereTheUserSwitchesThemOff) {
  EXPECT_EQ(notes_on("-gravity 0,0 -body_balance false -contact none"), Notes{});
}

// One option for all groups has an effect if it has one on any of them.
TEST(IdleOptions, OfAllGroupsAreToldOnlyIfIdleInAll) {
  const std::string two = "-cloths towel,sock -towel_shape flat -cloths_crumpling 0.1 ";
  EXPECT_EQ(notes_on(two + "-sock_shape flat").size(), 1U);
  EXPECT_EQ(notes_on(two + "-sock_shape crumpled"), Notes{});
}

}  // namespace
}  // namespace washfsi::test
