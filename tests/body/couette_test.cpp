// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "body/couette_flow.hpp"

namespace washfsi::test {
namespace {

/// Root mean square over places of the cylinders' centre within a cell, of errors and of what the torques lack.
CircularCouette::Errors over_shifts(PetscInt n, BodyMethod method, double time) {
  const std::array<Point<2>, 4> shifts{Point<2>(0, 0), Point<2>(0.5, 0), Point<2>(0.3, 0.2), Point<2>(0.5, 0.5)};
  CircularCouette::Errors sum;
  for (const Point<2>& shift : shifts) {
    const auto errors = CircularCouette(n, shift, method).run(time, 0.4);
    sum.rms += errors.rms / 4;
    sum.max = std::max(sum.max, errors.max);
    sum.inner_torque += errors.inner_torque / 4;
    sum.outer_torque += errors.outer_torque / 4;
  }
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::printf("%3d^2  %-12s rms %.2e  max %.2e  torque / exact: inner %.4f, outer %.4f\n", static_cast<int>(n),
                method == BodyMethod::mapping ? "mapping" : "cut_stencil", sum.rms, sum.max, sum.inner_torque,
                sum.outer_torque);
    (void)std::fflush(stdout);
  }
  return sum;
}

TEST(CircularCouetteFlow, CutStencilsAreOfSecondOrder) {
  const auto coarse = over_shifts(49, BodyMethod::cut_stencil, 5), fine = over_shifts(97, BodyMethod::cut_stencil, 5);
  EXPECT_GE(std::log(coarse.rms / fine.rms) / std::log(97.0 / 49.0), 1.8);
  EXPECT_LT(fine.rms, 5e-3);
}

TEST(CircularCouetteFlow, CutStencilsBeatTheMaskAlone) {
  EXPECT_LT(over_shifts(33, BodyMethod::cut_stencil, 4).rms, 0.8 * over_shifts(33, BodyMethod::mapping, 4).rms);
}

// The table of docs/verification.md, long: run by `--gtest_also_run_disabled_tests --gtest_filter=*Table`.
TEST(CircularCouetteFlow, DISABLED_Table) {
  for (const auto method : {BodyMethod::mapping, BodyMethod::cut_stencil})
    for (const PetscInt n : {65, 129, 257}) (void)over_shifts(n, method, 20);
}

}  // namespace
}  // namespace washfsi::test
