// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/text.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

TEST(Text, OfANumberIsShortAndReadsBackToTheBit) {
  using Limits = std::numeric_limits<double>;
  for (const double value : {1.0 / 3, 0.1 + 0.2, -9.81, 6.02214076e23, Limits::min(), Limits::max(), Limits::epsilon()})
    EXPECT_EQ(std::strtod(to_text(value).c_str(), nullptr), value) << to_text(value);
  EXPECT_TRUE(std::signbit(std::strtod(to_text(-0.0).c_str(), nullptr)));
  EXPECT_EQ(to_text(0.1), "0.1");  // not 0.1000000000000000055
  EXPECT_EQ(to_text(250), "250");
}

TEST(Text, IsSplitIntoEmptyWordsToo) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(split("1,2.5", ','), (Words{"1", "2.5"}));
  EXPECT_EQ(split("1,,2", ','), (Words{"1", "", "2"}));
  EXPECT_EQ(split("1,2,", ','), (Words{"1", "2", ""}));
  EXPECT_EQ(split(",1", ','), (Words{"", "1"}));
  EXPECT_EQ(split("", ','), Words{});
  EXPECT_EQ(split(join({"a", "b", "c"}, ","), ','), (Words{"a", "b", "c"}));
  EXPECT_EQ(split(join({"", "a", ""}, ","), ','), (Words{"", "a", ""}));
}

TEST(Text, IsQuotedWhereAnOptionsFileWouldCutIt) {
  EXPECT_EQ(quoted("out/run1"), "out/run1");
  EXPECT_EQ(quoted("my drum.stl"), "\"my drum.stl\"");
  EXPECT_EQ(quoted("run#1"), "\"run#1\"");
  EXPECT_EQ(quoted("5\"drum"), "'5\"drum'");
}

TEST(Text, OfAPointIsAnOptionsValue) {
  EXPECT_EQ(list_text<3>({1, -2.5, 0}), "1,-2.5,0");
}

}  // namespace
}  // namespace washfsi::test
