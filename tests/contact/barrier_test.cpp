// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier.hpp"

#include <gtest/gtest.h>

#include "contact/barrier_stack.hpp"
#include "support/random_points.hpp"
#include "washfsi/contact/barrier_function.hpp"
#include "washfsi/support/eigensystem.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

template <class T>
class BarrierTest : public testing::Test {};
TYPED_TEST_SUITE(BarrierTest, Dimensions, );

TYPED_TEST(BarrierTest, ForceIsMinusTheGradientOfItsEnergy) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  const auto barrier = stack.barrier(stack.all);
  const Points<Dim> forces = stack.forces(*barrier, stack.all), direction = random_points<Dim>(stack.all.size(), 12);
  double slope = 0;
  for (std::size_t m = 0; m < forces.size(); ++m) slope -= forces[m].dot(direction[m]);
  constexpr double e = 1e-8;
  const double difference =
      stack.energy(*barrier, stack.all + e * direction) - stack.energy(*barrier, stack.all - e * direction);
  EXPECT_GT(std::abs(slope), 1e-2);
  EXPECT_NEAR(difference / (2 * e), slope, 1e-5 * std::abs(slope));
}

TYPED_TEST(BarrierTest, ForcesHaveNoSumAndNoMoment) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  const auto barrier = stack.barrier(stack.all);
  const Points<Dim> forces = stack.forces(*barrier, stack.all);
  Point<Dim> sum = Point<Dim>::Zero();
  Rotation<Dim> moment = Rotation<Dim>::Zero();
  double size = 0;
  for (std::size_t m = 0; m < forces.size(); ++m) {
    sum += forces[m];
    moment += cross<Dim>(stack.all[m], forces[m]);
    size += forces[m].norm();
  }
  EXPECT_GT(size, 1);
  EXPECT_LE(sum.norm(), 1e-12 * size);
  EXPECT_LE(moment.norm(), 1e-12 * size);
}

// Shifted by what is no part of the grid, and turned.
TYPED_TEST(BarrierTest, TurnsWithTheCloths) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  Eigen::Matrix<double, Dim, Dim> turn;
  if constexpr (Dim == 2)
    turn = Eigen::Rotation2D<double>(0.7).toRotationMatrix();
  else
    turn = Eigen::AngleAxisd(0.7, Point<3>(1, 2, 3).normalized()).toRotationMatrix();
  Points<Dim> turned = stack.all;
  for (auto& place : turned) place = turn * place + Point<Dim>::Constant(0.0123);
  const Points<Dim> forces = stack.forces(*stack.barrier(stack.all), stack.all),
                    turned_forces = stack.forces(*stack.barrier(turned), turned);
  for (std::size_t m = 0; m < forces.size(); ++m)
    EXPECT_LE((turn * forces[m] - turned_forces[m]).norm(), 1e-9 * (1 + forces[m].norm()));
}

// One image of a stack lies across the sides of a periodic box.
TYPED_TEST(BarrierTest, ActsAcrossPeriodicSides) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack(0.6 * distance, true);
  Points<Dim> split = stack.all;
  for (auto& place : split) place += Point<Dim>::Constant(0.5);
  const std::size_t of_cloth = split.size() / 3;
  for (std::size_t m = of_cloth; m < 2 * of_cloth; ++m) split[m] -= Point<Dim>::Ones();
  const Points<Dim> forces = stack.forces(*stack.barrier(stack.all), stack.all),
                    split_forces = stack.forces(*stack.barrier(split), split);
  for (std::size_t m = 0; m < forces.size(); ++m)
    EXPECT_LE((forces[m] - split_forces[m]).norm(), 1e-9 * (1 + forces[m].norm()));
}

TYPED_TEST(BarrierTest, StiffnessIsThatOfItsBlocksAndNeverNegative) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  const auto barrier = stack.barrier(stack.all);
  const auto size = static_cast<Eigen::Index>(stack.all.size() * Dim);
  const Eigen::MatrixXd matrix = stack.stiffness(*barrier, GeometricStiffness::of_tension);
  EXPECT_LE((matrix - matrix.transpose()).norm(), 1e-12 * matrix.norm());
  const Eigen::VectorXd eigenvalues = eigensystem<Eigen::Dynamic>(matrix).values;
  EXPECT_GT(eigenvalues[size - 1], 1e3);
  EXPECT_GE(eigenvalues[0], -1e-10 * eigenvalues[size - 1]);

  const Points<Dim> direction = random_points<Dim>(stack.all.size(), 13);
  Points<Dim> rates(stack.cloths->owned(), Point<Dim>::Zero());
  barrier->add_force_rates(stack.own(stack.all), stack.own(direction), rates);
  const Eigen::VectorXd product =
      matrix * Eigen::Map<const Eigen::VectorXd>(direction[0].data(), static_cast<Eigen::Index>(size));
  for (std::size_t m = 0; m < rates.size(); ++m) {
    const Eigen::Index row = (stack.cloths->begin() + static_cast<PetscInt>(m)) * Dim;
    EXPECT_LE((rates[m] + product.segment<Dim>(row)).norm(), 1e-9 * matrix.norm());
  }
}

// Of uneven surfaces that are not so near that pairs of facets guard what is between them.
TYPED_TEST(BarrierTest, AllOfTheStiffnessIsItsJacobian) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack(0.75 * distance);
  const auto barrier = stack.barrier(stack.all);
  const Eigen::MatrixXd matrix = stack.stiffness(*barrier, GeometricStiffness::all);
  const Points<Dim> direction = random_points<Dim>(stack.all.size(), 13);
  constexpr double e = 1e-8;
  const Points<Dim> rates =
      1 / (2 * e) *
      (stack.forces(*barrier, stack.all + e * direction) - stack.forces(*barrier, stack.all - e * direction));
  const Eigen::Map<const Eigen::VectorXd> expected(rates[0].data(), matrix.rows());
  const Eigen::VectorXd product = matrix * Eigen::Map<const Eigen::VectorXd>(direction[0].data(), matrix.rows());
  EXPECT_GT(expected.norm(), 100);
  EXPECT_LE((product + expected).norm(), 1e-5 * expected.norm());
}

// Two flat sheets press each other with -kappa b', wherever and however the one lies over the other, and with nothing
// along themselves.
TYPED_TEST(BarrierTest, PressureDoesNotDependOnWhereASheetLies) {
  constexpr int Dim = TypeParam::value;
  Stack<Dim> stack;
  const std::size_t of_cloth = stack.all.size() / 3;
  const double gap = 0.7 * distance, pressure = -1e4 * washfsi::barrier(0.7).first;
  for (const double shift : {0.0, 0.25, 0.5, 1.0})
    for (const double turn : {0.0, 0.3, 0.8}) {
      if (Dim == 2 && turn > 0) continue;
      // a small sheet over the middle of a large one, and the third far off
      for (std::size_t m = 0; m < stack.all.size(); ++m) {
        const std::size_t cloth = m / of_cloth, width = Dim == 3 ? 5 : 1, in_cloth = m % of_cloth;
        Point<Dim> place = Point<Dim>::Zero();
        place[0] = spacing * (static_cast<double>(in_cloth / width) - 2.5);
        if constexpr (Dim == 3) place[1] = spacing * (static_cast<double>(in_cloth % width) - 2);
        if (cloth == 1) {
          place *= 0.4;
          const Point<Dim> before = place;
          place[0] = std::cos(turn) * before[0] - std::sin(turn) * before[1] * (Dim == 3) + 0.5 * shift * spacing;
          if constexpr (Dim == 3) place[1] = std::sin(turn) * before[0] + std::cos(turn) * before[1];
        }
        place[Dim - 1] = gap * static_cast<double>(cloth == 2 ? 20 : cloth);
        stack.all[m] = place;
      }
      const auto barrier = stack.barrier(stack.all);
      const Points<Dim> forces = stack.forces(*barrier, stack.all);
      const double area = Dim == 3 ? spacing * spacing * 30 : spacing * 6;  // of samples of the small one, half
      double normal = 0;
      Point<Dim> sum = Point<Dim>::Zero();
      for (std::size_t m = of_cloth; m < 2 * of_cloth; ++m) sum += forces[m];
      normal = sum[Dim - 1];
      sum[Dim - 1] = 0;
      // those of the large one over the small one make up the rest, by how many there are
      EXPECT_GE(normal, 0.5 * pressure * area * (1 - 1e-9)) << shift << " " << turn;
      EXPECT_LE(sum.norm(), 0.06 * normal) << shift << " " << turn;
    }
}

// Along the normal of flat cloths what is left out of the stiffness far from a solution is that of what faces each
// other aslant, at rims: it makes the rest never too soft.
TYPED_TEST(BarrierTest, StiffnessIsNeverTooSoftAlongTheNormal) {
  constexpr int Dim = TypeParam::value;
  Stack<Dim> stack;
  const auto of_cloth = stack.all.size() / 3;
  for (std::size_t m = 0; m < stack.all.size(); ++m)
    stack.all[m][Dim - 1] = 0.6 * distance * static_cast<double>(m / of_cloth);
  const auto barrier = stack.barrier(stack.all);
  Points<Dim> direction(stack.all.size(), Point<Dim>::Zero());
  for (std::size_t m = of_cloth; m < 2 * of_cloth; ++m) direction[m] = Point<Dim>::Unit(Dim - 1);
  Points<Dim> rates(stack.cloths->owned(), Point<Dim>::Zero());
  barrier->add_force_rates(stack.own(stack.all), stack.own(direction), rates);
  const Points<Dim> all_rates = of_all_ranks(PETSC_COMM_WORLD, rates);
  constexpr double e = 1e-7;
  const Points<Dim> more = stack.forces(*barrier, stack.all + e * direction),
                    less = stack.forces(*barrier, stack.all - e * direction);
  for (std::size_t m = 0; m < all_rates.size(); ++m) {
    const double expected = (more[m] - less[m])[Dim - 1] / (2 * e);
    EXPECT_GE(std::abs(all_rates[m][Dim - 1]), std::abs(expected) * (1 - 1e-5));
  }
}

// However far the cloths are to go: stopped before they touch; and held back one by one.
TYPED_TEST(BarrierTest, NoMotionGoesThroughACloth) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  for (const double size : {1e-4, 1e-2, 1.0}) {
    const Points<Dim> motion = random_points<Dim>(stack.all.size(), 14, size);
    const auto barrier = stack.barrier(stack.all);
    const double part = barrier->step_limit(stack.own(stack.all), stack.own(motion));
    EXPECT_GT(part, 0);
    EXPECT_LT(part, size < 1 ? 1.1 : 1e-2);
    const double before = stack.energy(*barrier, stack.all), after = stack.energy(*barrier, stack.all + part * motion);
    EXPECT_TRUE(std::isfinite(after));
    EXPECT_GT(before, 0);
    Points<Dim> held = stack.own(motion);
    barrier->shorten(stack.own(stack.all), held);
    EXPECT_EQ(barrier->step_limit(stack.own(stack.all), held), 1);
  }
}

TYPED_TEST(BarrierTest, RefusesADistanceThatACellHasNoRoomFor) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  const Surroundings<Dim> around{*stack.grid, *stack.boundary, stack.bodies, *stack.cloths};
  EXPECT_THROW(Barrier<Dim>({0.011, 1e4}, around), InputError);
  EXPECT_DOUBLE_EQ(Barrier<Dim>({0, 1e4}, around).distances().usual(), 0.16 * spacing);
}

TYPED_TEST(BarrierTest, LeavesAFlatClothAlone) {
  constexpr int Dim = TypeParam::value;
  Stack<Dim> stack(10 * distance);
  const auto barrier = stack.barrier(stack.all);
  EXPECT_EQ(stack.energy(*barrier, stack.all), 0);
}

}  // namespace
}  // namespace washfsi::test
