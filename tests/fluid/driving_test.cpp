// SPDX-License-Identifier: BSD-3-Clause
//
// Water that a mean pressure gradient, or a bulk velocity that is kept, drives between two walls.
#include <gtest/gtest.h>

#include "support/water.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

constexpr double channel_viscosity = 2, channel_density = 3, channel_height = 1;  // half of it is 1/2

/// A channel along the axis `along`, with walls across the next one.
template <int Dim>
class Channel {
 public:
  Channel(int along, PetscInt cells, const DrivingOptions<Dim>& driving)
      : along_(along),
        across_((along + 1) % Dim),
        grid_(PETSC_COMM_WORLD, shape(cells)),
        boundary_(grid_, sides()),
        water_(grid_, boundary_, options(driving)) {}

  void run(int steps, double dt) {
    for (int n = 0; n < steps; ++n) water_.advance(dt);
  }
  /// Largest deviation from a parabola with this peak.
  double off_parabola(double peak) {
    const ConstFaceView<Dim> u(grid_.face_dm(), fluid().velocity());
    double worst = 0;
    for_each<Dim>(grid_.inner_faces(along_), [&](const Index<Dim>& face) {
      const double y = grid_.face_center(face, along_)[across_] / channel_height;
      worst = std::max(worst, std::abs(u(face, along_) - peak * 4 * y * (1 - y)));
    });
    return largest(grid_.comm(), worst);
  }
  /// One step in which the gradient drives only a share of all faces.
  void run_with_share(double share, double dt) {
    const petsc::GlobalVector shares(grid_.face_dm());
    WASH_PETSC(VecSet(shares, share));
    const petsc::GlobalVector none_held(grid_.face_dm());
    WASH_PETSC(VecSet(none_held, 1.0));
    StepFields<Dim> fields{water_.liquid.fields(), water_.force, {none_held, water_.force}};
    fields.driven_share = shares;
    water_.take_step(dt, fields);
  }
  Point<Dim> bulk() { return mean_velocity<Dim>(grid_, fluid().velocity()); }
  FractionalStep<Dim>& fluid() { return water_.fluid; }
  const Grid<Dim>& grid() const { return grid_; }

 private:
  GridShape<Dim> shape(PetscInt cells) const {
    GridShape<Dim> shape;
    shape.cells.fill(8);
    shape.cells[across_] = cells;
    shape.upper[across_] = channel_height;
    shape.periodic.fill(true);
    shape.periodic[across_] = false;
    return shape;
  }
  typename Boundary<Dim>::Sides sides() const {
    typename Boundary<Dim>::Sides sides;
    for (int d = 0; d < Dim; ++d)
      if (d != across_) sides[d][0].kind = sides[d][1].kind = BoundaryKind::periodic;
    return sides;
  }
  static FluidOptions<Dim> options(const DrivingOptions<Dim>& driving) {
    FluidOptions<Dim> options;
    options.density = channel_density;
    options.viscosity = channel_viscosity;
    options.momentum_tolerance = 1e-14;
    options.pressure_tolerance = 1e-13;
    options.driving = driving;
    return options;
  }

  int along_, across_;
  Grid<Dim> grid_;
  Boundary<Dim> boundary_;
  Water<Dim> water_;
};

template <int Dim>
DrivingOptions<Dim> gradient(int along, double value) {
  DrivingOptions<Dim> driving;
  driving.pressure_gradient[along] = value;
  return driving;
}

template <int Dim>
DrivingOptions<Dim> bulk_velocity(int along, double value) {
  DrivingOptions<Dim> driving;
  driving.bulk_velocity[along] = value;
  return driving;
}

/// The parabola's peak under a gradient [m/s].
double peak_of(double pressure_gradient) {
  return -pressure_gradient * channel_height * channel_height / (8 * channel_viscosity);
}

template <int Dim>
void expect_parabola(int along) {
  double errors[2];
  for (int n = 0; n < 2; ++n) {
    Channel<Dim> channel(along, n == 0 ? 12 : 24, gradient<Dim>(along, -16));
    channel.run(400, 0.01);
    errors[n] = channel.off_parabola(peak_of(-16));
    EXPECT_GT(channel.bulk()[along], 0) << "a negative gradient drives forwards";
  }
  EXPECT_LT(errors[0], 0.02 * peak_of(-16));
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
}

TEST(Driving, GradientGivesTheParabolaInSecondOrderInThePlane) {
  expect_parabola<2>(0);
  expect_parabola<2>(1);
}

TEST(Driving, GradientGivesTheParabolaInSecondOrderInSpace) {
  expect_parabola<3>(2);
}

template <int Dim>
void expect_kept_bulk(int along) {
  Channel<Dim> channel(along, 32, bulk_velocity<Dim>(along, 0.5));
  for (int n = 0; n < 300; ++n) {
    channel.run(1, n % 2 == 0 ? 0.01 : 0.007);
    EXPECT_NEAR(channel.bulk()[along], 0.5, 1e-13);
  }
  const double friction = -12 * channel_viscosity * 0.5 / (channel_height * channel_height);
  EXPECT_NEAR(channel.fluid().driving().gradient()[along] / friction, 1, 2e-3);
  EXPECT_LT(channel.off_parabola(0.75), 2e-3);
}

TEST(Driving, BulkVelocityIsKeptAndItsGradientIsThatOfTheFriction) {
  expect_kept_bulk<2>(0);
  expect_kept_bulk<3>(1);
}

// The same flow, driven in either way, also in time: not only where it rests.
TEST(Driving, BulkVelocityAndItsGradientGiveTheSameFlow) {
  Channel<2> held(0, 16, bulk_velocity<2>(0, 0.5));
  held.run(400, 0.01);
  Channel<2> driven(0, 16, gradient<2>(0, held.fluid().driving().gradient()[0]));
  driven.run(400, 0.01);
  EXPECT_NEAR(driven.bulk()[0], 0.5, 1e-10);
  EXPECT_NEAR(driven.off_parabola(0.75), held.off_parabola(0.75), 1e-10);
}

// The rest of the force is the bodies': from rest, before friction matters.
TEST(Driving, DrivesOnlyItsShare) {
  constexpr double share = 0.25, dt = 1e-6;
  Channel<3> channel(0, 32, gradient<3>(0, -16));
  channel.run_with_share(share, dt);
  EXPECT_NEAR(channel.bulk()[0] / (share * 16 / channel_density * dt), 1, 1e-3);
  const Point<3> held = mean_velocity<3>(channel.grid(), channel.fluid().constraint_force());
  EXPECT_NEAR(held[0], (1 - share) * -16, 1e-12);
  const Point<3> part =
      mean_velocity<3>(channel.grid(), channel.fluid().velocity(), channel.fluid().constraint_force());
  EXPECT_NEAR(part[0], channel.bulk()[0] * held[0], 1e-12);
}

TEST(Driving, RefusesWhatCannotBe) {
  EXPECT_THROW(Channel<2>(0, 8, gradient<2>(1, -1)), InputError) << "across walls";
  EXPECT_THROW(Channel<2>(0, 8, bulk_velocity<2>(1, 1)), InputError) << "across walls";
  DrivingOptions<2> both = gradient<2>(0, -1);
  both.bulk_velocity[0] = 1;
  EXPECT_THROW(Channel<2>(0, 8, both), InputError);
}

}  // namespace
}  // namespace washfsi::test
