// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/machine_axis.hpp"

#include <gtest/gtest.h>

#include "support/option_database.hpp"
#include "support/refusal.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

// In a box of 0.6 x 0.4 x 0.5 m.
MachineAxis axis_from(const std::string& text) {
  const OptionDatabase database(text);
  Options options(PETSC_COMM_WORLD);
  auto machine = MachineAxis::from_options(options, {-0.1, 0, 0.2}, {0.5, 0.4, 0.7});
  options.reject_unread();
  return machine;
}

// Half-way between the axis and the nearest sides, at half the height.
TEST(MachineAxis, IsInTheMiddleOfTheBoxUnlessGiven) {
  const MachineAxis machine = axis_from("");
  EXPECT_LE((machine.axis - Point<2>(0.2, 0.2)).norm(), 1e-15);
  EXPECT_LE((machine.orbit_center - Point<2>(0.1, 0.45)).norm(), 1e-15);
}

TEST(MachineAxis, TakesItsOrbitWithItUnlessThatIsGiven) {
  const MachineAxis machine = axis_from("-machine_axis 0.1,0.3");  // 0.1 m from the nearest side
  EXPECT_LE((machine.orbit_center - Point<2>(0.05, 0.45)).norm(), 1e-15);
}

TEST(MachineAxis, IsWhereTheUserSays) {
  const MachineAxis machine = axis_from("-machine_axis 0.5,0 -machine_orbit_center 0,0.7");  // at the box's end
  EXPECT_EQ(machine.axis, Point<2>(0.5, 0));
  EXPECT_EQ(machine.orbit_center, Point<2>(0, 0.7));
}

TEST(MachineAxis, IsRefusedOutsideTheBox) {
  const std::vector<std::pair<std::string, std::string>> refused{
      {"-machine_axis 0.6,0.2", "-machine_axis 0.6,0.2: must be in the box, x,y from -0.1,0 to 0.5,0.4"},
      {"-machine_axis 0.2,-0.1", "-machine_axis 0.2,-0.1: must be in the box"},
      {"-machine_orbit_center 0.1,0.1",
       "-machine_orbit_center 0.1,0.1: must be a distance >= 0 and a height in the box"},
      {"-machine_orbit_center 0.1,0.8", "from 0.2 to 0.7"},
      {"-machine_orbit_center -0.1,0.4", "-machine_orbit_center -0.1,0.4: must be a distance >= 0"},
      {"-machine_axis 0.2", "-machine_axis 0.2: must be 2 numbers"},
  };
  expect_refusals<InputError>(axis_from, refused);
}

}  // namespace
}  // namespace washfsi::test
