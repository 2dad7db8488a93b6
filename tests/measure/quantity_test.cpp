// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/quantity.hpp"

#include <gtest/gtest.h>

#include "support/hand_over.hpp"

namespace washfsi::test {
namespace {

/// Four quantities of one number, which accumulate differently.
struct Listed {
  Listed() {
    const auto now = [this] { return value; };
    list.add({"present", "m", "as it is", now});
    list.add({"record", "m", "the largest so far", now, Accumulation::largest_so_far, "/records/one"});
    list.add({"watched", "m", "as it is; the largest is told", now, Accumulation::largest, "/records/two"});
    list.add({"", "-", "only in the summary", now, Accumulation::none, "/last", true});
    list.keep("average", kept);
  }
  void measure(double now) {
    value = now;
    list.accumulate();
  }

  double value = 0;
  std::array<double, 2> kept{3, 4};
  QuantityList list;
};

TEST(QuantityList, TellsColumnsAndTheirValuesInOneOrder) {
  Listed listed;
  listed.measure(5);
  listed.measure(2);
  std::vector<std::string> names;
  for (const Column& column : listed.list.columns()) names.push_back(column.name);
  EXPECT_EQ(names, (std::vector<std::string>{"present", "record", "watched"}));
  EXPECT_EQ(listed.list.row(), (std::vector<double>{2, 5, 2}));
}

TEST(QuantityList, TellsTheLargestOfTheRunInTheSummary) {
  Listed listed;
  listed.measure(5);
  listed.measure(2);
  EXPECT_EQ(listed.list.summary_value("/records/one"), 5);
  EXPECT_EQ(listed.list.summary_value("/records/two"), 5);
  EXPECT_EQ(listed.list.summary_value("/last"), 2);
  EXPECT_EQ(listed.list.summary_value("/nothing"), 0);
}

// What a checkpoint keeps is all that another list needs to go on.
TEST(QuantityList, GoesOnFromWhatACheckpointKeeps) {
  Listed first, second;
  first.measure(5);
  first.kept[1] = 7;
  StateList state;
  first.list.register_state(state);
  ASSERT_EQ(state.entries().size(), 4U);
  hand_over(first.list, second.list);
  first.measure(2);
  second.measure(2);
  EXPECT_EQ(first.list.row(), second.list.row());
  EXPECT_EQ(second.list.summary_value("/records/two"), 5);
  EXPECT_EQ(second.kept[1], 7);
}

TEST(QuantityList, DocumentsEveryColumn) {
  const Listed listed;
  EXPECT_NE(listed.list.document().find("| `record` | m | the largest so far |"), std::string::npos);
}

}  // namespace
}  // namespace washfsi::test
