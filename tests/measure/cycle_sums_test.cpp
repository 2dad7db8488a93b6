// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cycle_sums.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

const std::vector<CycleFigure> of_all_kinds{{"mean", "W", OverCycle::mean, ""},
                                            {"rms", "W", OverCycle::rms, ""},
                                            {"peak", "W", OverCycle::peak, ""},
                                            {"work", "J", OverCycle::integral, ""},
                                            {"rise", "W", OverCycle::change, ""}};

// The value of all quantities at the end of an interval.
void take_and_add(CycleSums& sums, double value, double interval) {
  sums.take(std::vector<double>(5, value));
  sums.add(interval);
}

// 2 W for 1 s, then -4 W for 3 s.
TEST(CycleSums, WeighEachValueByItsInterval) {
  CycleSums sums(of_all_kinds);
  sums.take(std::vector<double>(5, 1.0));
  sums.begin();
  take_and_add(sums, 2, 1);
  take_and_add(sums, -4, 3);
  const std::vector<double> expected{-2.5, std::sqrt(13.0), 4, -10, -5};
  ASSERT_EQ(sums.so_far().size(), expected.size());
  for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_NEAR(sums.so_far()[n], expected[n], 1e-14) << n;
  EXPECT_EQ(sums.elapsed(), 4);
}

TEST(CycleSums, BeginEachCycleWithTheValuesTakenLast) {
  CycleSums sums(of_all_kinds);
  take_and_add(sums, 7, 2);
  sums.begin();
  EXPECT_EQ(sums.at_start(), std::vector<double>(5, 7.0));
  EXPECT_EQ(sums.so_far(), std::vector<double>(5, 0.0));  // numbers, although no time has passed
  take_and_add(sums, 9, 1);
  EXPECT_EQ(sums.so_far(), (std::vector<double>{9, 9, 9, 9, 2}));
}

// Put in 10 J, of which 3 are lost and 5 kept.
TEST(CycleSums, TellTheEnergyThatIsNotAccountedFor) {
  CycleSums sums({{"lost", "J", OverCycle::integral, "", -1},
                  {"put_in", "J", OverCycle::integral, "", 1},
                  {"kept", "J", OverCycle::change, "", -1},
                  {"speed", "m/s", OverCycle::mean, ""}});
  ASSERT_EQ(sums.figures().size(), 5U);
  EXPECT_EQ(sums.figures().back().name, "energy_open");
  EXPECT_EQ(sums.figures().back().unit, "J");
  sums.take({0, 0, 100, 0});
  sums.begin();
  sums.take({1.5, 5, 105, 8});
  sums.add(2);
  EXPECT_NEAR(sums.so_far().back(), 2, 1e-14);
}

TEST(CycleSums, HaveNoBalanceWhereNothingIsPutIn) {
  const CycleSums sums({{"lost", "J", OverCycle::integral, "", -1}});
  EXPECT_EQ(sums.figures().size(), 1U);
  EXPECT_EQ(sums.so_far().size(), 1U);
}

TEST(CycleSums, GoOnFromTheNumbersThatARestartKeeps) {
  CycleSums first(of_all_kinds), second(of_all_kinds);
  first.begin();
  take_and_add(first, 2, 1);
  const auto kept = first.kept();
  auto restored = second.kept();
  for (std::size_t n = 0; n < kept.size(); ++n) std::ranges::copy(kept[n].second, restored[n].second.begin());
  second.kept_elapsed() = first.kept_elapsed();
  EXPECT_EQ(second.so_far(), first.so_far());
  for (CycleSums* sums : {&first, &second}) take_and_add(*sums, -5, 0.5);
  EXPECT_EQ(second.so_far(), first.so_far());
}

}  // namespace
}  // namespace washfsi::test
