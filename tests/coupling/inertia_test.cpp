// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/inertia.hpp"

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "washfsi/measure/carried_mass.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi::test {
namespace {

CaseOptions<2> heavy_fibre(double excess_mass) {
  CaseOptions<2> options = fibre_in_water(excess_mass, 0);
  options.model.cloth.mass_carrier = MassCarrier::cloth;
  return options;
}

CouplingOptions coupling_with_inertia(const std::string& name) {
  CouplingOptions options;
  options.scheme = name.starts_with("semi_implicit") ? "semi_implicit" : "implicit";
  options.mobility = name == "semi_implicit_row_sums" ? Mobility::row_sums : Mobility::matrix;
  options.time_scheme = name == "implicit_trapezoidal" ? TimeScheme::trapezoidal : TimeScheme::backward_euler;
  options.order = name == "semi_implicit_second_order" ? 2 : 1;
  options.tolerance = 1e-9;
  options.sweeps = most_sweeps_with_inertia;
  return options;
}

// Of the water.
Point<2> momentum(const System<2>& system) {
  const Model<2>& model = system.model;
  Point<2> sum = Point<2>::Zero();
  const ConstFaceView<2> u(model.grid.face_dm(), model.fluid.velocity());
  const ConstFaceView<2> rho(model.grid.face_dm(), model.liquid.density());
  for_each<2>(model.grid.owned(), [&](const Index<2>& face) {
    for (int c = 0; c < 2; ++c) sum[c] += rho(face, c) * u(face, c) * model.grid.cell_volume();
  });
  for (int c = 0; c < 2; ++c) sum[c] = ordered_sum(model.grid.comm(), sum[c]);
  return sum;
}

Point<2> given(const System<2>& system) {
  Point<2> sum = Point<2>::Zero();
  for (const Point<2>& force : system.step.force_on_water) sum += force;
  for (int c = 0; c < 2; ++c) sum[c] = ordered_sum(system.model.grid.comm(), sum[c]);
  return sum;
}

class EveryCarrier : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Inertia, EveryCarrier,
                         testing::Values("semi_implicit", "semi_implicit_row_sums", "semi_implicit_second_order",
                                         "implicit_trapezoidal", "implicit_backward_euler"),
                         [](const auto& test) { return test.param; });

// What a velocity adds to the momentum of the cloth.
Point<2> momentum_of(const System<2>& system, const Points<2>& velocities) {
  Point<2> sum = Point<2>::Zero();
  for (std::size_t m = 0; m < velocities.size(); ++m) sum += system.model.cloths.marker_masses()[m] * velocities[m];
  for (int c = 0; c < 2; ++c) sum[c] = ordered_sum(system.model.grid.comm(), sum[c]);
  return sum;
}

// Nothing but their own inertia is left of the cloths' forces in sum, by BDF2 or by the velocities at the ends, and the
// water gets it all, in steps of varying length.
TEST_P(EveryCarrier, ExchangesMomentumOfClothAndWaterExactly) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, heavy_fibre(5), {});
  disturb(*system, 0.004);
  for (auto& velocity : system->state.velocities) velocity = {0.1, 0.3};
  system->state.velocities_before = system->state.velocities;
  const auto scheme = make_coupling_scheme<2>(coupling_with_inertia(GetParam()), *system);
  const bool bdf2 = GetParam() != "implicit_trapezoidal" && GetParam() != "semi_implicit_second_order";
  double scale = 0, dt_before = 0;
  for (int n = 0; n < 30; ++n) {
    const double dt = n % 3 == 0 ? 2e-4 : 3e-4;
    const Points<2> now = system->state.velocities, before = system->state.velocities_before;
    const Point<2> water = momentum(*system);
    scheme->advance(*system, dt);
    const double ratio = !bdf2 ? 0 : dt_before > 0 ? dt / dt_before : 1;
    const Point<2> gained = momentum_of(*system, (1 + 2 * ratio) / (1 + ratio) * system->state.velocities -
                                                     (1 + ratio) * now + ratio * ratio / (1 + ratio) * before);
    scale = std::max(scale, gained.norm());
    EXPECT_LE((momentum(*system) - water - dt * given(*system)).norm(), 1e-10 * scale);
    EXPECT_LE((dt * given(*system) + gained).norm(), 1e-6 * scale) << "step " << n;  // the coupling's tolerance
    dt_before = dt;
  }
  EXPECT_GT(scale, 1e-4);
}

// Thrown at water at rest, the cloth has lost what the water has gained, the first step's impulse included.
TEST_P(EveryCarrier, LosesNoMomentumWhereItStartsSuddenly) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, heavy_fibre(5), {});
  auto& state = system->state;
  Points<2>&velocities = state.velocities, &before = state.velocities_before;
  velocities.assign(velocities.size(), Point<2>(0.1, 0.3));
  before = state.mean_velocities = velocities;
  const bool carries_end = GetParam() == "implicit_trapezoidal" || GetParam() == "semi_implicit_second_order";
  const Point<2> thrown = momentum_of(*system, velocities);
  const auto scheme = make_coupling_scheme<2>(coupling_with_inertia(GetParam()), *system);
  Point<2> gained = Point<2>::Zero();
  for (int n = 0; n < 10; ++n) {
    scheme->advance(*system, 3e-4);
    gained += 3e-4 * given(*system);
  }
  const Point<2> left = momentum_of(*system, carries_end ? velocities : 1.5 * velocities - 0.5 * before);
  EXPECT_GT(gained.norm(), 0.3 * thrown.norm());
  EXPECT_LE((gained + left - thrown).norm(), 1e-5 * thrown.norm());  // the coupling's tolerance
}

// Where the markers are after a while in steps that vary by a factor of two, if asked.
Points<2> places_after(const std::string& name, double time, int steps, bool varying) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, heavy_fibre(5), {});
  disturb(*system, 1e-3);
  CouplingOptions options = coupling_with_inertia(name);
  options.sweeps = 2;
  options.slip_tolerance = 0;
  const auto scheme = make_coupling_scheme<2>(options, *system);
  for (int n = 0; n < steps; ++n)
    scheme->advance(*system, time / steps * (!varying ? 1 : n % 4 < 2 ? 2.0 / 3 : 4.0 / 3));
  return of_all_ranks(PETSC_COMM_WORLD, system->state.positions);
}

double largest_distance(const Points<2>& a, const Points<2>& b) {
  double largest = 0;
  for (std::size_t m = 0; m < a.size(); ++m) largest = std::max(largest, (a[m] - b[m]).norm());
  return largest;
}

double observed_order(const std::string& name, bool varying) {
  const double time = 0.016;
  const Points<2> coarse = places_after(name, time, 40, varying), medium = places_after(name, time, 80, varying),
                  fine = places_after(name, time, 160, varying);
  return std::log2(largest_distance(coarse, medium) / largest_distance(medium, fine));
}

TEST(Inertia, LeavesTheOrderInTime) {
  EXPECT_GT(observed_order("semi_implicit", false), 0.8);
  EXPECT_GT(observed_order("semi_implicit_second_order", false), 1.8);
  EXPECT_GT(observed_order("semi_implicit_second_order", true), 1.8);
}

// Any mass, from none to ten times the water's in a cell, at steps far beyond what its springs would bear.
TEST(Inertia, OfAnyMassIsStableAndSlipsLittle) {
  for (const double mass : {0.0, 1.0, 100.0}) {
    CaseOptions<2> options = heavy_fibre(mass);
    options.model.fluid.momentum_tolerance = options.model.fluid.pressure_tolerance = 1e-7;
    const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
    disturb(*system, 2e-3);
    const auto scheme = make_coupling_scheme<2>(coupling_with_inertia("semi_implicit"), *system);
    for (int n = 0; n < 30; ++n) scheme->advance(*system, 2e-3);
    EXPECT_LE(system->step.cloth_slip, 0.02) << mass;
    for (const Point<2>& velocity : system->state.velocities) EXPECT_TRUE(velocity.allFinite());
  }
}

// Where and how turned a fibre starts, and its markers on coarse cells.
struct Start {
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  Point<2> cells = Point<2>::Zero();  ///< away from the middle of the box
  PetscInt markers = 14;
};

// Displacements, turned back, of a straight fibre that is thrown into a wave far from the sides of a box. It is never
// compressed, which would make it buckle.
Points<2> displacements(const std::string& name, int finer, const Start& how) {
  CaseOptions<2> options = heavy_fibre(5);
  options.model.grid.shape.cells = {96 * finer, 96 * finer};
  options.model.grid.shape.upper = {0.96, 0.96};
  const PetscInt markers = how.markers * finer;
  options.model.cloths[0].markers = {markers, 1};
  options.model.cloths[0].sheet.ds = 0.2 / static_cast<double>(markers);
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  auto& state = system->state;
  Points<2>&positions = state.positions, &velocities = state.velocities;
  const Point<2> middle(0.16, 0.16);
  for (std::size_t m = 0; m < positions.size(); ++m) {
    velocities[m] = how.turn * Point<2>(0, 0.3 * std::sin(2 * std::numbers::pi * (positions[m][0] - 0.06) / 0.2));
    positions[m] = (3 * middle + 0.01 / finer * how.cells + how.turn * (positions[m] - middle)).eval();
  }
  state.velocities_before = state.mean_velocities = velocities;
  const Points<2> start = positions;
  const auto scheme = make_coupling_scheme<2>(coupling_with_inertia(name), *system);
  for (int n = 0; n < 40; ++n) scheme->advance(*system, 1e-3);
  Points<2> moved = positions - start;
  for (Point<2>& d : moved) d = (how.turn.transpose() * d).eval();
  return of_all_ranks(PETSC_COMM_WORLD, moved);
}

class EveryOrder : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Inertia, EveryOrder, testing::Values("semi_implicit", "semi_implicit_second_order"),
                         [](const auto& test) { return test.param; });

double largest_of(const Points<2>& displacements) {
  return largest_distance(displacements, Points<2>(displacements.size(), Point<2>::Zero()));
}

// Whole cells and swapped axes change nothing; half a cell and a turn less and less, the finer the grid.
TEST_P(EveryOrder, DoesNotDependOnPlaceAndDirection) {
  const auto part = [](int finer, const Start& how) {
    const Points<2> here = displacements(GetParam(), finer, {});
    EXPECT_GT(largest_of(here), 3e-4);
    return largest_distance(displacements(GetParam(), finer, how), here) / largest_of(here);
  };
  EXPECT_LE(part(1, {.cells = {3, -2}}), 1e-7);
  EXPECT_LE(part(1, {.turn = Eigen::Matrix2d::Identity().rowwise().reverse()}), 1e-7);
  const Start half_a_cell{.cells = {0.5, 0.5}}, turned{.turn = Eigen::Rotation2Dd(0.5).toRotationMatrix()};
  for (const Start& how : {half_a_cell, turned}) {
    const double coarse = part(1, how), fine = part(2, how);
    EXPECT_LE(coarse, 0.04);
    EXPECT_LE(fine, 0.7 * coarse);
  }
}

// Which is no longer so where markers lie nearer than cells: then the fibre locks unless it is along an axis
// (docs/theory/coupling.md). The table there.
TEST(Inertia, MarkersNearerThanCellsLock) {
  std::vector<double> parts;
  for (const PetscInt markers : {14, 20, 40})
    for (const int finer : {1, 2}) {
      const Start aligned{.markers = markers},
          turned{.turn = Eigen::Rotation2Dd(0.5).toRotationMatrix(), .markers = markers};
      const Points<2> here = displacements("semi_implicit_second_order", finer, aligned);
      parts.push_back(largest_distance(displacements("semi_implicit_second_order", finer, turned), here) /
                      largest_of(here));
      RecordProperty(std::to_string(markers) + "_" + std::to_string(finer), std::to_string(parts.back()));
    }
  EXPECT_LE(parts[1], 0.7 * parts[0]);
  EXPECT_GE(parts[5], parts[4]);
}

// At rest in a stream that moves with it, a cloth feels nothing, whatever its mass.
TEST(Inertia, OfAClothThatMovesWithTheWaterIsNotFelt) {
  CaseOptions<2> options = heavy_fibre(50);
  options.model.cloths[0].velocity = {0.2, 0.1};
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  system->model.fluid.start([](const Point<2>&, int c) { return c == 0 ? 0.2 : 0.1; });
  const Points<2> start = system->state.positions;
  const auto scheme = make_coupling_scheme<2>(coupling_with_inertia("semi_implicit"), *system);
  for (int n = 0; n < 20; ++n) scheme->advance(*system, 1e-3);
  for (std::size_t m = 0; m < start.size(); ++m)
    EXPECT_LE((system->state.positions[m] - start[m] - 0.02 * Point<2>(0.2, 0.1)).norm(), 1e-12);
}

// How far a bar of mass 100 kg/m2, stretched by 1e-4 m in its first longitudinal mode and left to itself in nearly
// weightless water, is stretched after each step of a period.
std::vector<double> stretch_over_a_period(const std::string& scheme_name, int steps) {
  CaseOptions<2> options = heavy_fibre(100);
  options.model.fluid.density = 0.01;
  options.model.fluid.viscosity = 1e-7;
  options.model.fluid.momentum_tolerance = options.model.fluid.pressure_tolerance = 1e-7;
  options.model.cloths[0].sheet.fabric = LinearFabric({.ke_s = 1000, .kb_s = 0});
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, {});
  Points<2>& x = system->state.positions;
  for (Point<2>& place : x) place[0] -= 1e-4 * std::cos(std::numbers::pi * (place[0] - 0.06) / 0.2);
  // w = pi/L sqrt(Ke/m) for a bar with free ends, with 20 markers 2/ds sin(pi/40) sqrt(Ke/m)
  const double w = 2 / 0.01 * std::sin(std::numbers::pi / 40) * std::sqrt(1000.0 / 100);
  const auto scheme = make_coupling_scheme<2>(coupling_with_inertia(scheme_name), *system);
  std::vector<double> stretch;
  for (int n = 0; n <= steps; ++n) {
    const Points<2> all = of_all_ranks(PETSC_COMM_WORLD, x);
    stretch.push_back((all.back() - all.front())[0] - 0.19);
    scheme->advance(*system, 2 * std::numbers::pi / w / steps);
  }
  return stretch;
}

double quarter_of_period(const std::vector<double>& stretch) {
  for (std::size_t n = 1; n < stretch.size(); ++n)
    if (stretch[n] < 0)
      return (static_cast<double>(n) - stretch[n] / (stretch[n] - stretch[n - 1])) /
             static_cast<double>(stretch.size() - 1);
  return 1;
}

// At 100 steps a period, w dt = 0.063, backward differences leave 0.9990 of the amplitude a step
// (docs/theory/coupling.md).
TEST(Inertia, SwingsAHeavyFibreWithItsOwnPeriodAndLittleDamping) {
  const auto first = stretch_over_a_period("semi_implicit", 100),
             second = stretch_over_a_period("semi_implicit_second_order", 100);
  EXPECT_NEAR(quarter_of_period(first), 0.25, 0.01);
  EXPECT_NEAR(quarter_of_period(second), 0.25, 0.001);
  EXPECT_NEAR(first.back() / first.front(), std::pow(0.99902, 100), 0.01);
  EXPECT_NEAR(second.back() / second.front(), 1, 0.003);
}

}  // namespace
}  // namespace washfsi::test
