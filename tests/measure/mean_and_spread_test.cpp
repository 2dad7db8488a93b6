// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/mean_and_spread.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

TEST(MeanAndSpread, AreThoseOfTheSamples) {
  MeanAndSpread figures(2);
  for (const double x : {1.0, 2.0, 4.0}) figures.add({x, -1e9 + x});  // the second has hardly any spread for its size
  EXPECT_EQ(figures.count(), 3);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_NEAR(figures.of(n).mean, n == 0 ? 7.0 / 3 : -1e9 + 7.0 / 3, 1e-6);
    EXPECT_NEAR(figures.of(n).deviation, std::sqrt(7.0 / 3), 1e-6);  // (16 + 1 + 25)/9/2
  }
}

TEST(MeanAndSpread, OfOneSampleIsZeroAndOfNoneBeginsAnew) {
  MeanAndSpread figures(1);
  figures.add({3});
  EXPECT_EQ(figures.of(0).mean, 3);
  EXPECT_EQ(figures.of(0).deviation, 0);
  figures.forget();
  EXPECT_EQ(figures.count(), 0);
  figures.add({5});
  EXPECT_EQ(figures.of(0).mean, 5);
}

}  // namespace
}  // namespace washfsi::test
