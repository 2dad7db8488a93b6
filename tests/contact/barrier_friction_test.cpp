// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "contact/barrier_stack.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

template <class T>
class BarrierFrictionTest : public testing::Test {};
TYPED_TEST_SUITE(BarrierFrictionTest, Dimensions, );

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return ordered_sum(PETSC_COMM_WORLD, sum);
}

// The upper cloths slide over the lowest, which stays, by less than a step of creep and by much more.
TYPED_TEST(BarrierFrictionTest, FrictionIsThatOfCoulombAndTheGradientOfItsEnergy) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  const auto barrier = stack.barrier(stack.all, 0.4), smooth = stack.barrier(stack.all);
  const std::size_t of_cloth = stack.all.size() / 3;
  for (const double slide : {2e-7, 1e-4}) {
    Points<Dim> moved = stack.all;
    for (std::size_t m = of_cloth; m < moved.size(); ++m) moved[m][0] += slide;
    const auto friction = [&](const Points<Dim>& places) {
      return stack.forces(*barrier, places) - stack.forces(*smooth, places);
    };
    const auto energy = [&](const Points<Dim>& places) {
      return stack.energy(*barrier, places) - stack.energy(*smooth, places);
    };
    const Points<Dim> forces = friction(moved), direction = random_points<Dim>(moved.size(), 15);
    double slope = 0, pull = 0;
    Point<Dim> sum = Point<Dim>::Zero();
    for (std::size_t m = 0; m < moved.size(); ++m) {
      slope -= forces[m].dot(direction[m]);
      sum += forces[m];
      if (m < of_cloth) pull += forces[m][0];
    }
    constexpr double e = 1e-9;
    const double difference = energy(moved + e * direction) - energy(moved - e * direction);
    EXPECT_NEAR(difference / (2 * e), slope, 1e-3 * std::abs(slope));
    EXPECT_LE(sum.norm(), 1e-12 * std::abs(pull) * static_cast<double>(moved.size()));
    // between the two upper cloths nothing slides: all friction is that of the lowest one with the middle one
    MarkerContact before(stack.cloths->owned()), after = before;
    barrier->add_marker_contact(stack.own(stack.all), before);
    barrier->add_marker_contact(stack.own(moved), after);
    const double normal = sum_of(before.normal_force) / 4, power = sum_of(after.friction_power) * 1e-3;
    EXPECT_NEAR(power, pull * slide, 0.05 * power);
    if (slide > 1e-6) {
      EXPECT_NEAR(pull, 0.4 * normal, 0.1 * pull);
    } else {
      EXPECT_LT(pull, 0.3 * normal);
    }
  }
}

// The upper cloths come nearer to the lowest, which stays, or go from it.
TYPED_TEST(BarrierFrictionTest, MotionAlongTheNormalIsDampedByTheGradientOfAnEnergy) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  const auto damped = stack.barrier(stack.all, 0, 1), smooth = stack.barrier(stack.all);
  const std::size_t of_cloth = stack.all.size() / 3;
  for (const double nearer : {1e-6, 3e-6, -1e-6}) {
    Points<Dim> moved = stack.all;
    for (std::size_t m = of_cloth; m < moved.size(); ++m) moved[m][Dim - 1] -= nearer;
    const auto damping = [&](const Points<Dim>& places) {
      return stack.forces(*damped, places) - stack.forces(*smooth, places);
    };
    const Points<Dim> forces = damping(moved), direction = random_points<Dim>(moved.size(), 15);
    double slope = 0, push = 0, size = 0;
    Point<Dim> sum = Point<Dim>::Zero();
    for (std::size_t m = 0; m < moved.size(); ++m) {
      slope -= forces[m].dot(direction[m]);
      sum += forces[m];
      size += forces[m].norm();
      if (m >= of_cloth) push += forces[m][Dim - 1];
    }
    EXPECT_LE(sum.norm(), 1e-12 * (size + 1));
    constexpr double e = 1e-10;
    const auto energy = [&](double way) {
      return stack.energy(*damped, moved + way * direction) - stack.energy(*smooth, moved + way * direction);
    };
    EXPECT_NEAR((energy(e) - energy(-e)) / (2 * e), slope, 1e-3 * std::abs(slope));
    EXPECT_GT(push * nearer, 0);
    MarkerContact contact(stack.cloths->owned());
    damped->add_marker_contact(stack.own(moved), contact);
    EXPECT_NEAR(sum_of(contact.friction_power) * 1e-3, push * nearer, 1e-6 * push * nearer);
  }
}

// First at least as stiff along any direction, so that Newton's steps do not overshoot, then just as stiff.
TYPED_TEST(BarrierFrictionTest, FrictionsStiffnessBecomesItsHessian) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  for (const double slide : {2e-7, 9.5e-7, 1e-4}) {
    const auto barrier = stack.barrier(stack.all, 0.4), smooth = stack.barrier(stack.all);
    Points<Dim> moved = stack.all;
    for (std::size_t m = moved.size() / 3; m < moved.size(); ++m) moved[m][0] += slide;
    const Points<Dim> direction = random_points<Dim>(moved.size(), 15);
    const auto forces = [&](double way) {
      const Points<Dim> places = moved + way * direction;
      return stack.forces(*barrier, places) - stack.forces(*smooth, places);
    };
    const auto rates = [&] {
      Points<Dim> with(stack.cloths->owned(), Point<Dim>::Zero()), without = with;
      barrier->add_force_rates(stack.own(moved), stack.own(direction), with);
      smooth->add_force_rates(stack.own(moved), stack.own(direction), without);
      return of_all_ranks(PETSC_COMM_WORLD, with - without);
    };
    const auto dot = [](const Points<Dim>& a, const Points<Dim>& b) {
      double sum = 0;
      for (std::size_t m = 0; m < a.size(); ++m) sum += a[m].dot(b[m]);
      return sum;
    };
    constexpr double e = 1e-10;
    const Points<Dim> expected = 1 / (2 * e) * (forces(e) - forces(-e));
    EXPECT_LE(dot(direction, rates()), dot(direction, expected));
    // one that does not slide at all here has a kink there
    for (const double way : {1e-8, 1e-11, 0.0}) barrier->linearise(stack.own(moved + way * direction));
    const Points<Dim> error = rates() - expected;
    EXPECT_LE(dot(error, error), 1e-6 * dot(expected, expected)) << slide;
  }
}

// Each rank alone, and all together: what rubs on a marker is known to its owner whole.
TYPED_TEST(BarrierFrictionTest, ExplicitFrictionIsTheSameOnAnyNumberOfRanks) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> shared, alone(0.6 * distance, false, PETSC_COMM_SELF);
  const Points<Dim> forces = shared.explicit_forces(), expected = alone.explicit_forces(),
                    smooth = alone.forces(*alone.barrier(alone.all), alone.all);
  double friction = 0;
  for (std::size_t m = 0; m < expected.size(); ++m) {
    EXPECT_LE((forces[m] - expected[m]).norm(), 1e-12 * (1 + expected[m].norm())) << m;
    friction += (expected[m] - smooth[m]).norm();
  }
  EXPECT_GT(friction, 0.1);
}

}  // namespace
}  // namespace washfsi::test
