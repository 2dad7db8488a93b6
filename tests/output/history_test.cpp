// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/history.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/scratch_folder.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/text.hpp"

namespace washfsi::test {
namespace {

using Lines = std::vector<std::string>;

const char* const torque_file = "history.csv";

History torque_history(const ScratchFolder& folder, long restart_step, const std::string& unit = "N m") {
  return {PETSC_COMM_WORLD, folder.file(torque_file), {{"step", "-"}, {"time", "s"}, {"torque", unit}}, restart_step};
}

// Steps of half a second.
void append_steps(History& history, long first, long last) {
  for (long step = first; step <= last; ++step) history.append(step, {0.5 * static_cast<double>(step), -2});
}

TEST(History, HasNamesThenUnitsThenARowOfEachStepOnDiskAtOnce) {
  const ScratchFolder folder;
  History history = torque_history(folder, -1);
  EXPECT_EQ(folder.lines(torque_file), (Lines{"step,time,torque", "# -,s,N m"}));
  append_steps(history, 0, 1);
  EXPECT_EQ(folder.lines(torque_file), (Lines{"step,time,torque", "# -,s,N m", "0,0,-2", "1,0.5,-2"}));
}

TEST(History, AfterARestartLosesTheRowsBehindItAndNoOther) {
  const ScratchFolder folder;
  {
    History history = torque_history(folder, -1);
    append_steps(history, 8, 12);
  }
  History history = torque_history(folder, 10);
  append_steps(history, 11, 11);
  EXPECT_EQ(folder.lines(torque_file),
            (Lines{"step,time,torque", "# -,s,N m", "8,4,-2", "9,4.5,-2", "10,5,-2", "11,5.5,-2"}));
}

TEST(History, OfANewRunHasNoRowsOfAnEarlierOne) {
  const ScratchFolder folder;
  {
    History history = torque_history(folder, -1);
    append_steps(history, 0, 3);
  }
  const History history = torque_history(folder, -1);
  EXPECT_EQ(folder.lines(torque_file).size(), 2U);
}

// Rows of other units must not stand below these.
TEST(History, OfOtherColumnsIsBegunAnew) {
  const ScratchFolder folder;
  {
    History history = torque_history(folder, -1);
    append_steps(history, 0, 3);
  }
  const History history = torque_history(folder, 3, "kN m");
  EXPECT_EQ(folder.lines(torque_file), (Lines{"step,time,torque", "# -,s,kN m"}));
}

TEST(History, LosesARowThatAKilledRunHasCutOff) {
  const ScratchFolder folder;
  folder.write(torque_file, "step,time,torque\n# -,s,N m\n1,0.5,-2\n2,1,-1.2");  // of -1.25, perhaps
  const History history = torque_history(folder, 5);
  EXPECT_EQ(folder.lines(torque_file), (Lines{"step,time,torque", "# -,s,N m", "1,0.5,-2"}));
}

TEST(History, KeepsItsRowsWhereItCannotBeWrittenAnew) {
  const ScratchFolder folder;
  folder.write(torque_file, "step,time,torque\n# -,s,N m\n1,0.5,-2\n");
  std::filesystem::create_directory(folder.file(std::string(torque_file) + ".part"));
  expect_refusal<FileError>([&] { (void)torque_history(folder, 1); }, "history.csv: cannot be written");
  EXPECT_EQ(folder.lines(torque_file).size(), 3U);
}

TEST(History, IsRefusedWhereThereIsNoFolder) {
  const ScratchFolder folder;
  const std::string path = folder.file("missing/history.csv");
  expect_refusal<FileError>(
      [&] {
        const History history(PETSC_COMM_WORLD, path, {{"step", "-"}}, -1);
      },
      "missing/history.csv: cannot be written");
}

TEST(WrittenTable, HasNumbersThatReadBackToTheBit) {
  const ScratchFolder folder;
  const std::vector<double> numbers{1.0 / 3, 0.1 + 0.2, -6.02214076e23, 1e-300, std::numeric_limits<double>::max()};
  write_table(PETSC_COMM_WORLD, folder.file("table.csv"), {{"a", "m"}}, {numbers, {-0.0}});
  const Lines lines = folder.lines("table.csv");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[1], "# m");
  const Lines words = split(lines[2], ',');
  ASSERT_EQ(words.size(), numbers.size());
  for (std::size_t n = 0; n < words.size(); ++n) EXPECT_EQ(std::strtod(words[n].c_str(), nullptr), numbers[n]);
  EXPECT_TRUE(std::signbit(std::strtod(lines[3].c_str(), nullptr)));
}

}  // namespace
}  // namespace washfsi::test
