// SPDX-License-Identifier: BSD-3-Clause
//
// Phase averages of flows whose means, turbulence and dissipation are known. All of it is compared on each number of
// ranks.
#include "washfsi/statistics/phase_statistics.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

/// A velocity as a function of the place.
using Flow = std::function<Point<3>(const Point<3>&)>;

/// A box whose axis goes through its middle in a given direction, the same seen along any. Its velocity is exact on all
/// faces, ghosts too.
class Machine {
 public:
  explicit Machine(int axis = 2) : axis_(axis), grid_(PETSC_COMM_WORLD, shape()), local_(grid_.face_dm()) {}

  /// Flow and liquid in the machine's own frame: its axis is the third.
  LiquidMoment set(const Flow& flow) {
    const FaceView<3> u(grid_.face_dm(), local_);
    Box<3> all = grid_.owned();
    for (int d = 0; d < 3; ++d) --all.lower[d], ++all.upper[d];
    for_each<3>(all, [&](const Index<3>& cell) {
      for (int d = 0; d < 3; ++d) u(cell, d) = turned(flow(turned(grid_.face_center(cell, d), 1)), -1)[d];
    });
    return {
        .velocity = local_, .density = density, .pure_viscosity = viscosity, .viscosity = {.everywhere = viscosity}};
  }
  /// The machine's axis is `axis`: components in its frame, or back.
  Point<3> turned(const Point<3>& vector, int way) const {
    Point<3> result;
    for (int d = 0; d < 3; ++d) (way > 0 ? result[d] : result[box_axis(d)]) = vector[way > 0 ? box_axis(d) : d];
    return result;
  }
  PhaseOptions options(PetscInt count = 1, double period = 0) const {
    return {.count = count, .period = period, .axis = axis_, .center = Point<3>::Zero()};
  }
  const Grid<3>& grid() const { return grid_; }

  static constexpr double density = 800, viscosity = 1.6;
  static constexpr std::array<PetscInt, 3> cells{12, 12, 10};
  static constexpr std::array<double, 3> half{0.6, 0.6, 0.4};

 private:
  int box_axis(int own) const { return (own + axis_ + 1) % 3; }
  GridShape<3> shape() const {
    GridShape<3> shape;
    for (int d = 0; d < 3; ++d) {
      const auto own = static_cast<std::size_t>(d);
      shape.cells[static_cast<std::size_t>(box_axis(d))] = cells[own];
      shape.lower[box_axis(d)] = -half[own];
      shape.upper[box_axis(d)] = half[own];
    }
    return shape;
  }

  int axis_;
  Grid<3> grid_;
  petsc::LocalVector local_;
};

/// Over all bins with a cell, of a phase.
template <class Visit>
void for_each_ring(const PhaseStatistics& phases, std::size_t phase, const Visit& visit) {
  for (std::size_t bin = 0; bin < phases.bins().count(); ++bin)
    if (phases.bins().cells(bin) > 0)
      visit(phases.means(phase, bin), phases.bins().radii()[bin % phases.bins().radii().size()]);
}

PhaseStatistics& after_one_sample(PhaseStatistics& phases, const LiquidMoment& flow) {
  phases.begin();
  phases.observe(1, 1, flow);
  return phases;
}

TEST(PhaseStatistics, SolidBodyRotationIsNoTurbulence) {
  constexpr double omega = 3;
  Machine machine;
  PhaseStatistics phases(machine.grid(), machine.options());
  after_one_sample(phases, machine.set([](const Point<3>& x) { return Point<3>(-omega * x[1], omega * x[0], 0.7); }));
  for_each_ring(phases, 0, [&](const RingMeans& ring, double r) {
    EXPECT_NEAR(ring.velocity[0], 0, 1e-14);
    EXPECT_NEAR(ring.velocity[1], omega * r, 0.5 * omega * 0.1) << "to half a bin";
    EXPECT_NEAR(ring.velocity[2], 0.7, 1e-14);
    EXPECT_NEAR(ring.turbulence_energy, 0, 1e-13);
    EXPECT_NEAR(ring.dissipation, 0, 1e-13);
  });
  double turning = 0, expected = 0;  // each cell counts once
  for (std::size_t bin = 0; bin < phases.bins().count(); ++bin)
    if (phases.bins().cells(bin) > 0) turning += phases.bins().cells(bin) * phases.means(0, bin).velocity[1];
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) expected += 10 * omega * std::hypot(0.1 * i - 0.55, 0.1 * j - 0.55);
  EXPECT_NEAR(turning, expected, 1e-11);
}

TEST(PhaseStatistics, UniformFlowAcrossTheAxisIsAllTurbulence) {
  Machine machine;
  PhaseStatistics phases(machine.grid(), machine.options());
  after_one_sample(phases, machine.set([](const Point<3>&) { return Point<3>(0.8, 0, 0); }));
  for_each_ring(phases, 0, [&](const RingMeans& ring, double) {
    EXPECT_NEAR(ring.velocity.norm(), 0, 1e-14);
    EXPECT_NEAR(ring.turbulence_energy, 0.5 * 0.8 * 0.8, 1e-14);
  });
}

TEST(PhaseStatistics, OnTheAxisRadiusHasNoDirection) {
  Machine machine;
  PhaseOptions options = machine.options();
  options.center = Point<3>(0.05, 0.05, 0);  // in the middle of a cell
  PhaseStatistics phases(machine.grid(), options);
  after_one_sample(phases, machine.set([](const Point<3>&) { return Point<3>(0.8, 0, 0.3); }));
  ASSERT_EQ(phases.bins().cells(0), 1);
  EXPECT_NEAR((phases.means(0, 0).velocity - Point<3>(0, 0, 0.3)).norm(), 0, 1e-14);
  EXPECT_NEAR(phases.means(0, 0).turbulence_energy, 0.5 * 0.8 * 0.8, 1e-14);
}

// Up and down along the axis in the first of four phases, the same in all others.
TEST(PhaseStatistics, WhatAlternatesFromCycleToCycleIsTurbulence) {
  Machine machine;
  PhaseStatistics phases(machine.grid(), machine.options(4, 1));
  phases.begin();
  for (int step = 1; step <= 16; ++step) {  // a step for each phase of four cycles
    const double up = step % 4 != 1 ? 0.4 : step % 8 == 1 ? 0.6 : -0.6;
    phases.observe(0.25 * step, 0.25, machine.set([&](const Point<3>&) { return Point<3>(0, 0, up); }));
  }
  for (std::size_t phase = 0; phase < 4; ++phase) {
    EXPECT_EQ(phases.samples(phase), 4);
    EXPECT_NEAR(phases.averaged_time(phase), 1, 1e-14);
    for_each_ring(phases, phase, [&](const RingMeans& ring, double) {
      EXPECT_NEAR(ring.velocity[2], phase == 0 ? 0 : 0.4, 1e-14);
      EXPECT_NEAR(ring.turbulence_energy, phase == 0 ? 0.5 * 0.6 * 0.6 : 0, 1e-14);
    });
  }
}

TEST(PhaseStatistics, SamplesWeighTheirTimeInThePhaseOfItsMiddle) {
  Machine machine;
  PhaseOptions options = machine.options(2, 1);
  options.sampling.start = 0.1;
  PhaseStatistics phases(machine.grid(), options);
  phases.begin();
  const auto rises = [&](double w) { return machine.set([=](const Point<3>&) { return Point<3>(0, 0, w); }); };
  phases.observe(0.2, 0.2, rises(1));  // from 0.1 on
  phases.observe(0.6, 0.4, rises(3));  // its middle is 0.4
  phases.observe(0.9, 0.3, rises(5));
  phases.observe(1.05, 0.15, rises(6));  // 0.975
  EXPECT_NEAR(phases.averaged_time(0), 0.5, 1e-14);
  EXPECT_NEAR(phases.averaged_time(1), 0.45, 1e-14);
  EXPECT_NEAR(phases.means(0, 0).velocity[2], (0.1 * 1 + 0.4 * 3) / 0.5, 1e-13);
  EXPECT_NEAR(phases.means(1, 0).velocity[2], (0.3 * 5 + 0.15 * 6) / 0.45, 1e-13);
}

TEST(PhaseStatistics, ShearAndStretchingDissipate) {
  constexpr double shear = 2, stretch = 0.5, nu = Machine::viscosity / Machine::density;
  Machine machine;
  PhaseStatistics phases(machine.grid(), machine.options());
  after_one_sample(phases, machine.set([](const Point<3>& x) {
    return Point<3>(shear * x[1] + stretch * x[0], -stretch * x[1], 3 * shear * x[0]);
  }));
  const double expected = nu * (shear * shear + 9 * shear * shear + 4 * stretch * stretch);
  for_each_ring(phases, 0, [&](const RingMeans& ring, double) {
    EXPECT_NEAR(ring.dissipation, expected, 1e-12 * expected);
    EXPECT_EQ(ring.model_dissipation, 0);
  });
}

TEST(PhaseStatistics, ModelsDissipateByTheirPart) {
  constexpr double shear = 2, added = 0.4;
  Machine machine;
  ViscosityField<3> viscosity(machine.grid());
  WASH_PETSC(VecSet(viscosity.in_cells(), Machine::viscosity + added));
  viscosity.find_edges();
  LiquidMoment flow = machine.set([](const Point<3>& x) { return Point<3>(shear * x[1], 0, 0); });
  flow.viscosity = viscosity.viscosity();
  PhaseStatistics phases(machine.grid(), machine.options());
  after_one_sample(phases, flow);
  for_each_ring(phases, 0, [&](const RingMeans& ring, double) {
    EXPECT_NEAR(ring.dissipation, Machine::viscosity / Machine::density * shear * shear, 1e-14);
    EXPECT_NEAR(ring.model_dissipation, added / Machine::density * shear * shear, 1e-14);
  });
}

// A body fills the half of the box where the first coordinate is negative; it moves, and the liquid does not.
TEST(PhaseStatistics, BodiesDoNotCount) {
  Machine machine;
  const petsc::Vector share = machine.grid().face_vector();
  {
    const FaceView<3> H(machine.grid().face_dm(), share);
    for_each<3>(machine.grid().owned(), [&](const Index<3>& cell) {
      for (int d = 0; d < 3; ++d) H(cell, d) = machine.grid().face_center(cell, d)[0] > -1e-9 ? 1 : 0;
    });
  }
  LiquidMoment flow = machine.set([](const Point<3>& x) { return Point<3>(0, 0, x[0] < -0.01 ? 9 : 0); });
  flow.fluid_share = share;
  PhaseStatistics phases(machine.grid(), machine.options());
  after_one_sample(phases, flow);
  double liquid = 0;
  for (std::size_t bin = 0; bin < phases.bins().count(); ++bin)
    liquid += phases.liquid_share(0, bin) * phases.bins().cells(bin);
  EXPECT_NEAR(liquid, 10 * 12 * (6 + 1.0 / 6), 1e-10) << "one of six faces of the cells beside it is in liquid";
  for_each_ring(phases, 0, [&](const RingMeans& ring, double) { EXPECT_LT(ring.velocity[2], 9.0 / 7 + 1e-12); });

  PhaseStatistics nothing(machine.grid(), machine.options());
  WASH_PETSC(VecSet(share, 0));
  flow.fluid_share = share;
  after_one_sample(nothing, flow);
  EXPECT_EQ(nothing.liquid_share(0, 0), 0);
  EXPECT_TRUE(std::isnan(nothing.means(0, 0).velocity[2]));
}

TEST(PhaseStatistics, TheAxisMayLieAlongAnyDirection) {
  const Flow flow = [](const Point<3>& x) {
    return Point<3>(std::sin(2 * x[1]) - x[2], x[0] * x[2] + 0.1, std::cos(3 * x[0]) * x[1] + x[2] * x[2]);
  };
  Machine upright(2);
  PhaseStatistics expected(upright.grid(), upright.options());
  after_one_sample(expected, upright.set(flow));
  for (const int axis : {0, 1}) {
    Machine lying(axis);
    PhaseStatistics found(lying.grid(), lying.options());
    after_one_sample(found, lying.set(flow));
    ASSERT_EQ(found.bins().count(), expected.bins().count());
    for (std::size_t bin = 0; bin < found.bins().count(); ++bin) {
      ASSERT_EQ(found.bins().cells(bin), expected.bins().cells(bin));
      if (found.bins().cells(bin) == 0) continue;
      const RingMeans a = found.means(0, bin), b = expected.means(0, bin);
      EXPECT_NEAR((a.velocity - b.velocity).norm(), 0, 1e-13);
      EXPECT_NEAR(a.turbulence_energy, b.turbulence_energy, 1e-13);
      EXPECT_NEAR(a.dissipation, b.dissipation, 1e-13);
    }
  }
}

TEST(PhaseStatistics, GoOnFromWhatACheckpointKeeps) {
  Machine machine;
  PhaseOptions options = machine.options(3, 0.7);
  options.sampling.interval = 0.2;
  PhaseStatistics straight(machine.grid(), options), before(machine.grid(), options), after(machine.grid(), options);
  straight.begin();
  before.begin();
  PhaseStatistics* parts[] = {&before, &after};
  for (int n = 0; n < 10; ++n) {
    if (n == 5) {
      std::ranges::copy(before.kept(), after.kept().begin());
      after.begin();
    }
    const LiquidMoment flow = machine.set([&](const Point<3>& x) { return Point<3>(n * x[1], x[0], n); });
    straight.observe(0.13 * (n + 1), 0.13, flow);
    parts[n / 5]->observe(0.13 * (n + 1), 0.13, flow);
  }
  EXPECT_TRUE(std::ranges::equal(straight.kept(), after.kept())) << "bit for bit";

  options.period = 0.8;
  PhaseStatistics others(machine.grid(), options);
  ASSERT_EQ(others.kept().size(), before.kept().size());
  std::ranges::copy(before.kept(), others.kept().begin());
  others.begin();
  EXPECT_EQ(others.averaged_time(0), 0) << "what is of another period counts for nothing";
}

TEST(PhaseStatistics, RefusesPhasesOfNoPeriodAndTooManyBins) {
  const Machine machine;
  EXPECT_THROW(PhaseStatistics(machine.grid(), machine.options(2)), InputError);
  PhaseOptions many = machine.options(10);
  many.period = 1;
  many.bins = {1000, 1000};
  EXPECT_THROW(PhaseStatistics(machine.grid(), many), InputError);
}

}  // namespace
}  // namespace washfsi::test
