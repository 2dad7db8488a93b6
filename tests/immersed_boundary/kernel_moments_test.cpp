// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/immersed_boundary/kernel_moments.hpp"

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

const KernelMoments yang_moments(DeltaKernel::yang, 2);

TEST(KernelMoments, AreThoseOfTheDelta) {
  EXPECT_NEAR(yang_moments.variance(), 0.3818, 1e-3);
  EXPECT_NEAR(yang_moments.retraction(10), 0.5 * yang_moments.sheet_reach(), 1e-9);
  double sum = 0, square = 0;
  constexpr double step = 0.01;
  for (int n = -400; n <= 400; ++n) {
    const double shift = n * step;
    sum += step * yang_moments.overlap(shift);
    square += step * yang_moments.overlap(shift) * shift * shift;
  }
  EXPECT_NEAR(sum, 1, 1e-4);
  EXPECT_NEAR(square, 2 * yang_moments.variance(), 1e-3);
  EXPECT_EQ(yang_moments.overlap(4.1), 0);
}

TEST(KernelMoments, PutOneSheetIntoThinParts) {
  const double thinnest = yang_moments.sheet_reach();
  for (const double b : {0.1, 0.3, 0.6}) EXPECT_NEAR(yang_moments.retraction(b), b, 1e-9);
  double before = thinnest;
  for (int n = 0; n < 23; ++n) {
    const double b = thinnest + 0.05 + 0.1 * n;
    EXPECT_LE(yang_moments.retraction(b), before + 2e-4);  // but for what the grid takes
    before = yang_moments.retraction(b);
  }
}

// The mean of |i - j| over the points that the kernels of a sheet along the grid reach: -|i - j|/2 is the discrete
// solution of u'' = delta.
TEST(SheetReach, IsThatOfADiscreteBend) {
  for (const DeltaKernel kernel : {DeltaKernel::cosine, DeltaKernel::yang, DeltaKernel::peskin}) {
    double sum = 0;
    constexpr int places = 50;
    for (int n = 0; n < places; ++n)
      for (int i = -4; i < 5; ++i)
        for (int j = -4; j < 5; ++j)
          sum += regularised_delta(kernel, i - (n + 0.5) / places, 2) *
                 regularised_delta(kernel, j - (n + 0.5) / places, 2) * std::abs(i - j) / places;
    EXPECT_NEAR(KernelMoments(kernel, 2).sheet_reach<2>({0, 1}, {7, 1}), sum, 0.01 * sum) << name_of(kernel);
  }
}

TEST(SheetReach, DependsOnTheCellsAcrossTheSheet) {
  const KernelMoments cosine(DeltaKernel::cosine, 2);
  const Point<3> up(0, 0, 1), diagonal = Point<3>(1, 1, 1).normalized();
  EXPECT_NEAR(cosine.sheet_reach<3>(up, {3, 2, 0.5}), 0.5 * cosine.sheet_reach<3>(up, {1, 1, 1}), 1e-12);
  EXPECT_NEAR(cosine.sheet_reach<3>(diagonal, {1, 1, 1}), 0.8268 - 0.0625 / 3, 1e-3);
  EXPECT_EQ(cosine.sheet_reach<3>(Point<3>::Zero(), {1, 1, 1}), 0);
}

}  // namespace
}  // namespace washfsi::test
