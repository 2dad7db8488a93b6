// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/barrier.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/contact/barrier_function.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi::test {
namespace {

constexpr double spacing = 0.02, distance = 0.005;

template <int Dim>
ClothGroup<Dim> towel() {
  ClothGroup<Dim> group;
  group.name = "towel";
  group.count = 3;
  group.markers = {6, Dim == 3 ? 5 : 1};
  group.sheet.width = Dim == 3 ? 5 : 1;
  group.sheet.ds = spacing;
  group.sheet.dr = Dim == 3 ? spacing : 1;
  return group;
}

/// Three cloths that lie one on another, uneven, in a large box, on some ranks.
template <int Dim>
struct Stack {
  explicit Stack(double gap = 0.6 * distance, bool is_periodic = false, MPI_Comm of_ranks = PETSC_COMM_WORLD)
      : comm(of_ranks) {
    GridShape<Dim> shape;
    shape.cells.fill(12);
    shape.lower = Point<Dim>::Constant(-0.5);
    shape.upper = Point<Dim>::Constant(0.5);
    if (is_periodic) shape.periodic.fill(true);
    grid = std::make_unique<Grid<Dim>>(comm, shape);
    boundary = std::make_unique<Boundary<Dim>>(*grid, typename Boundary<Dim>::Sides{});
    cloths = std::make_unique<Cloths<Dim>>(comm, std::vector<ClothGroup<Dim>>{towel<Dim>()});
    const auto count = static_cast<std::size_t>(cloths->marker_count());
    const Points<Dim> rough = random_points<Dim>(count, 11, 0.09 * distance);
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t width = cloths->groups()[0].sheet.width, in_cloth = n % (6 * width), cloth = n / (6 * width);
      Point<Dim> place = Point<Dim>::Zero();
      place[0] = spacing * static_cast<double>(in_cloth / width) + 0.3 * spacing * static_cast<double>(cloth);
      if constexpr (Dim == 3) place[1] = spacing * static_cast<double>(in_cloth % width) + 0.004 * place[0];
      place[Dim - 1] = gap * static_cast<double>(cloth);
      all.push_back(place + rough[n]);
    }
  }
  Points<Dim> own(const Points<Dim>& values) const {
    return {values.begin() + cloths->begin(), values.begin() + cloths->end()};
  }
  std::unique_ptr<Barrier<Dim>> barrier(const Points<Dim>& places, double friction = 0, double damping = 0) const {
    auto result = std::make_unique<Barrier<Dim>>(BarrierOptions{distance, 0, 1e4, friction, 0, damping},
                                                 Surroundings<Dim>{*grid, *boundary, bodies, *cloths});
    const Points<Dim> start = own(places), at_rest(start.size(), Point<Dim>::Zero());
    start_apart(*result);
    result->begin_step({start, at_rest, 0, 1e-3});
    return result;
  }
  /// What starts in contact would have a distance of its own.
  void start_apart(Barrier<Dim>& barrier) const {
    Points<Dim> apart = own(all);
    for (std::size_t m = 0; m < apart.size(); ++m)
      apart[m][Dim - 1] += 2 * distance * static_cast<double>(cloths->piece_of_marker()[m]);
    const Points<Dim> at_rest(apart.size(), Point<Dim>::Zero());
    barrier.begin_step({apart, at_rest, 0, 0});
  }
  Points<Dim> forces(const Barrier<Dim>& barrier, const Points<Dim>& places) const {
    Points<Dim> result(cloths->owned(), Point<Dim>::Zero());
    barrier.add_force(own(places), {}, result);
    return of_all_ranks(comm, result);
  }
  Eigen::MatrixXd stiffness(const Barrier<Dim>& barrier, GeometricStiffness geometric) const {
    const auto size = static_cast<Eigen::Index>(all.size() * Dim);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    barrier.visit_stiffness(own(all), geometric, [&](PetscInt row, PetscInt column, const StiffnessBlock<Dim>& block) {
      matrix.block<Dim, Dim>(row * Dim, column * Dim) += block;
    });
    MPI_Allreduce(MPI_IN_PLACE, matrix.data(), static_cast<int>(matrix.size()), MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return matrix;
  }
  double energy(const Barrier<Dim>& barrier, const Points<Dim>& places) const {
    std::vector<double> result(1, 0.0);
    barrier.add_energy(own(places), result);
    return ordered_sum(comm, result[0]);
  }
  /// Those of friction too, in an explicit step in which the cloths slide over each other.
  Points<Dim> explicit_forces() const {
    Barrier<Dim> barrier({distance, 0, 1e4, 0.4}, {*grid, *boundary, bodies, *cloths});
    const Points<Dim> start = own(all);
    Points<Dim> velocities(start.size(), Point<Dim>::Zero());
    for (std::size_t m = 0; m < velocities.size(); ++m)
      velocities[m][0] = 0.01 * static_cast<double>(cloths->piece_of_marker()[m]);
    const ExplicitStep lagged{1e-4, std::vector<double>(start.size(), 1e3)};
    start_apart(barrier);
    barrier.begin_step({start, velocities, 0, 0, {}, lagged});
    return forces(barrier, all);
  }

  MPI_Comm comm;
  std::unique_ptr<Grid<Dim>> grid;
  std::unique_ptr<Boundary<Dim>> boundary;
  std::vector<Body<Dim>> bodies;
  std::unique_ptr<Cloths<Dim>> cloths;
  Points<Dim> all;
};

template <class T>
class BarrierTest : public testing::Test {};
template <int N>
struct Dimension {
  static constexpr int value = N;
};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
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
  const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
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

double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return ordered_sum(PETSC_COMM_WORLD, sum);
}

// The upper cloths slide over the lowest, which stays, by less than a step of creep and by much more.
TYPED_TEST(BarrierTest, FrictionIsThatOfCoulombAndTheGradientOfItsEnergy) {
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
TYPED_TEST(BarrierTest, MotionAlongTheNormalIsDampedByTheGradientOfAnEnergy) {
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
TYPED_TEST(BarrierTest, FrictionsStiffnessBecomesItsHessian) {
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
TYPED_TEST(BarrierTest, ExplicitFrictionIsTheSameOnAnyNumberOfRanks) {
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

TYPED_TEST(BarrierTest, RefusesADistanceThatACellHasNoRoomFor) {
  constexpr int Dim = TypeParam::value;
  const Stack<Dim> stack;
  const Surroundings<Dim> around{*stack.grid, *stack.boundary, stack.bodies, *stack.cloths};
  EXPECT_THROW(Barrier<Dim>({0.011, 1e4}, around), InputError);
  EXPECT_DOUBLE_EQ(Barrier<Dim>({0, 1e4}, around).distance(), 0.16 * spacing);
}

TYPED_TEST(BarrierTest, LeavesAFlatClothAlone) {
  constexpr int Dim = TypeParam::value;
  Stack<Dim> stack(10 * distance);
  const auto barrier = stack.barrier(stack.all);
  EXPECT_EQ(stack.energy(*barrier, stack.all), 0);
}

}  // namespace
}  // namespace washfsi::test
