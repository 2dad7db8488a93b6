// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/forcing/surface_forcing.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "washfsi/body/primitives.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

constexpr double speed_of_rim = 0.3, radius = 0.15;

/// A disc that turns in water at rest, and others that do not.
class Discs {
 public:
  Discs(std::size_t at_rest, double slip_tolerance)
      : bodies_(discs(at_rest)),
        grid_(PETSC_COMM_WORLD, shape()),
        boundary_(grid_, {}),
        walls_(grid_, boundary_, bodies_, treatment(slip_tolerance), 1),
        density_(grid_.face_vector()),
        velocity_(grid_.face_vector()) {
    WASH_PETSC(VecSet(density_, 1));
    WASH_PETSC(VecZeroEntries(velocity_));
    walls_.update(0);
    walls_.begin_trial({0, 0.01}, density_);
  }

  bool push_unheld() { return walls_.push_unheld(velocity_, 1); }

  /// The largest force on a body's patches.
  double force_on(std::size_t body) {
    walls_.accept();
    double most = 0;
    for (std::size_t p = walls_.begin(); p < walls_.end(); ++p)
      if (walls_.markers().body_of(p) == body) most = std::max(most, walls_.kept()[p - walls_.begin()].norm());
    return largest(PETSC_COMM_WORLD, most);
  }

 private:
  static std::vector<Body<2>> discs(std::size_t at_rest) {
    std::vector<Body<2>> bodies(1 + at_rest);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      bodies[b].shape = std::make_unique<Sphere<2>>(radius);
      bodies[b].motion.center = {0.5 + static_cast<double>(b), 0.52};
    }
    bodies[0].motion.angular_speed = speed_of_rim / radius;
    return bodies;
  }
  static GridShape<2> shape() {
    GridShape<2> shape;
    shape.cells = {160, 40};
    shape.upper = {4, 1};
    return shape;
  }
  static BodyTreatment treatment(double slip_tolerance) {
    BodyTreatment treatment;
    treatment.method = BodyMethod::direct_forcing;
    treatment.slip_tolerance = slip_tolerance;
    return treatment;
  }

  std::vector<Body<2>> bodies_;
  Grid<2> grid_;
  Boundary<2> boundary_;
  SurfaceForcing<2> walls_;
  petsc::Vector density_, velocity_;
};

TEST(SurfaceForcing, PushesTheBodiesThatAreNotHeldAlone) {
  Discs discs(1, 0.1);
  EXPECT_TRUE(discs.push_unheld());
  EXPECT_GT(discs.force_on(0), 0);
  EXPECT_EQ(discs.force_on(1), 0);
}

TEST(SurfaceForcing, HoldsNoBodyWorseForOthersAtRest) {
  for (const std::size_t at_rest : {0, 1, 3}) {
    EXPECT_TRUE(Discs(at_rest, 0.8).push_unheld());
    EXPECT_FALSE(Discs(at_rest, 1.01).push_unheld());
  }
}

TEST(SurfaceForcing, HoldsBesidesABodyWithoutSurfaceInTheBox) {
  Discs discs(4, 0.1);  // the last lies beyond the end
  EXPECT_TRUE(discs.push_unheld());
  EXPECT_GT(discs.force_on(0), 0);
}

/// Of the means about the patches of a disc, root mean square; value(n) is that of the nth patch round it.
template <class Value>
double mean_about(Value&& value) {
  const Point<2> cell = Point<2>::Constant(0.025);
  const MarkerLayout<2> layout{cell, 1, KernelMoments(DeltaKernel::yang, 2)};
  const MarkerPatches<2> patches =
      surface_markers<2>(Sphere<2>(0.3), Bounds<2>::round(Point<2>::Zero(), Point<2>::Constant(1)), layout);
  std::vector<std::pair<double, std::size_t>> round;
  for (std::size_t p = 0; p < patches.size(); ++p)
    round.emplace_back(std::atan2(patches.middle(p)[1], patches.middle(p)[0]), p);
  std::sort(round.begin(), round.end());
  Points<2> values(patches.size());
  for (std::size_t n = 0; n < round.size(); ++n) values[round[n].second] = Point<2>(value(n), 0);
  double squares = 0;
  for (const auto& mean : OverlapInverse<2>(patches, layout).means_about(values, {0, values.size()}))
    squares += mean.squaredNorm();
  return std::sqrt(squares / static_cast<double>(patches.size()));
}

TEST(OverlapInverse, SeesWhatIsEvenAndHardlyWhatAlternates) {
  EXPECT_NEAR(mean_about([](std::size_t) { return 1.0; }), 1, 1e-12);
  EXPECT_LT(mean_about([](std::size_t n) { return n % 2 == 0 ? 1.0 : -1.0; }), 0.5);
}

}  // namespace
}  // namespace washfsi::test
