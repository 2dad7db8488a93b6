// SPDX-License-Identifier: BSD-3-Clause
//
// Statistics of flows whose means, stresses and spectra are known. All of it is compared on each number of ranks.
#include "washfsi/statistics/flow_statistics.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

constexpr double pi = std::numbers::pi;

/// A box with walls across y. Its velocity has two waves along x, the same in all of z, and is the same in y from face
/// to face of u: to the cells' centres u is halved by cos(k h / 2).
template <int Dim>
class FrozenFlow {
 public:
  FrozenFlow() : grid_(PETSC_COMM_WORLD, shape()), boundary_(grid_, sides()) {
    velocity_ = grid_.face_vector();
    pressure_ = grid_.cell_vector();
  }
  /// u = y + a cos(2 k x), v = b cos(2 k x + 1), p = c y + a sin(k x); the waves' strength is a factor.
  FlowMoment set(double strength) {
    {
      const FaceView<Dim> u(grid_.face_dm(), velocity_);
      const CellView<Dim> p(grid_.cell_dm(), pressure_);
      for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
        const Point<Dim> at_u = grid_.face_center(cell, 0), at_v = grid_.face_center(cell, 1);
        u(cell, 0) = at_u[1] + strength * a * std::cos(2 * k * at_u[0]);
        u(cell, 1) = strength * b * std::cos(2 * k * at_v[0] + 1);
        p(cell) = c * grid_.cell_center(cell)[1] + a * std::sin(k * grid_.cell_center(cell)[0]);
      });
    }
    local_.emplace(boundary_, grid_.face_dm(), velocity_, 0.0);
    return {*local_, pressure_};
  }
  const Grid<Dim>& grid() const { return grid_; }
  /// Of u at cells' centres.
  double smoothing() const { return std::cos(k * grid_.spacing()[0]); }
  double place(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * grid_.spacing()[1]; }

  static constexpr double length = 3, k = 2 * pi / length, a = 0.3, b = 0.2, c = 5;

 private:
  static GridShape<Dim> shape() {
    GridShape<Dim> shape;
    shape.cells.fill(9);
    shape.cells[0] = 12;
    shape.upper[0] = length;
    shape.periodic.fill(true);
    shape.periodic[1] = false;
    return shape;
  }
  static typename Boundary<Dim>::Sides sides() {
    typename Boundary<Dim>::Sides sides;
    for (std::size_t d = 0; d < Dim; ++d)
      for (Side<Dim>& side : sides[d]) side.kind = d == 1 ? BoundaryKind::slip : BoundaryKind::periodic;
    return sides;
  }

  Grid<Dim> grid_;
  Boundary<Dim> boundary_;
  petsc::Vector velocity_, pressure_;
  std::optional<GhostedVelocity<Dim>> local_;
};

template <int Dim>
void expect_known_means() {
  FrozenFlow<Dim> flow;
  FlowStatistics<Dim> statistics(flow.grid(), {.take = true});
  statistics.begin();
  statistics.observe(0.5, 0.5, flow.set(1));
  const double smoothing = flow.smoothing(), phase = -flow.k * flow.grid().spacing()[0];
  ASSERT_EQ(statistics.bins().count(), 9U);
  for (std::size_t bin = 1; bin + 1 < 9; ++bin) {  // v at walls is not the frozen one
    EXPECT_NEAR(statistics.mean("u")[bin], flow.place(bin), 1e-14);
    EXPECT_NEAR(statistics.mean("v")[bin], 0, 1e-14);
    EXPECT_NEAR(statistics.mean("p")[bin], flow.c * flow.place(bin), 1e-13);
    EXPECT_NEAR(statistics.mean("uu")[bin], 0.5 * std::pow(flow.a * smoothing, 2), 1e-14);
    EXPECT_NEAR(statistics.mean("vv")[bin], 0.5 * std::pow(flow.b, 2), 1e-14);
    EXPECT_NEAR(statistics.mean("pp")[bin], 0.5 * std::pow(flow.a, 2), 1e-12);
    // u is a cos(2 k x) smoothed, v is where p is
    EXPECT_NEAR(statistics.mean("uv")[bin], 0.5 * flow.a * smoothing * flow.b * std::cos(1.0), 1e-14) << phase;
  }
}

TEST(FlowStatistics, MeansAndStressesOfAFrozenFlow) {
  expect_known_means<2>();
  expect_known_means<3>();
}

TEST(FlowStatistics, SamplesWeighAsMuchAsTheirSteps) {
  FrozenFlow<3> flow;
  FlowStatistics<3> statistics(flow.grid(), {.take = true, .start = 1});
  statistics.begin();
  statistics.observe(0.9, 0.9, flow.set(7));  // before the start
  EXPECT_EQ(statistics.averaged_time(), 0);
  EXPECT_EQ(statistics.mean("u")[4], 0);
  statistics.observe(1.1, 0.2, flow.set(1));  // half of it
  statistics.observe(1.4, 0.3, flow.set(2));
  EXPECT_NEAR(statistics.averaged_time(), 0.4, 1e-15);
  const double mean_square = (0.1 * 1 + 0.3 * 4) / 0.4;
  EXPECT_NEAR(statistics.mean("vv")[4], mean_square * 0.5 * flow.b * flow.b, 1e-14);
}

TEST(FlowStatistics, IntervalsLeaveSamplesOutAndWeighTheOthers) {
  FrozenFlow<2> flow;
  FlowStatistics<2> statistics(flow.grid(), {.take = true, .interval = 0.3});
  statistics.begin();
  for (int n = 1; n <= 7; ++n) statistics.observe(0.1 * n, 0.1, flow.set(n % 3 == 0 ? 1 : 9));
  EXPECT_NEAR(statistics.averaged_time(), 0.6, 1e-14);
  EXPECT_NEAR(statistics.mean("vv")[4], 0.5 * flow.b * flow.b, 1e-14);
}

TEST(FlowStatistics, GoOnFromWhatACheckpointKeeps) {
  FrozenFlow<3> flow;
  const StatisticsOptions options{.take = true, .interval = 0.2, .spectra = {0.5}};
  FlowStatistics<3> straight(flow.grid(), options), before(flow.grid(), options), after(flow.grid(), options);
  straight.begin();
  before.begin();
  FlowStatistics<3>* parts[] = {&before, &after};
  for (int n = 0; n < 10; ++n) {
    if (n == 5) {
      std::ranges::copy(before.kept(), after.kept().begin());
      after.begin();
    }
    straight.observe(0.13 * (n + 1), 0.13, flow.set(n));
    parts[n / 5]->observe(0.13 * (n + 1), 0.13, flow.set(n));
  }
  EXPECT_TRUE(std::ranges::equal(straight.kept(), after.kept())) << "bit for bit";

  FlowStatistics<3> others(flow.grid(), {.take = true, .interval = 0.2, .spectra = {0.9}});
  ASSERT_EQ(others.kept().size(), before.kept().size());
  std::ranges::copy(before.kept(), others.kept().begin());
  others.begin();
  EXPECT_EQ(others.averaged_time(), 0) << "what is of other places counts for nothing";
}

TEST(FlowStatistics, SpectraHaveTheWaveAndTheWholeEnergy) {
  FrozenFlow<3> flow;
  FlowStatistics<3> statistics(flow.grid(), {.take = true, .spectra = {0.5}});
  statistics.begin();
  statistics.observe(1, 1, flow.set(1));
  ASSERT_EQ(statistics.places().size(), 2U);  // along x and along z
  const SpectrumPlace& along_x = statistics.places()[0];
  EXPECT_EQ(along_x.along, 0);
  EXPECT_NEAR(along_x.height, 0.5, 1e-14);
  const std::vector<double> energy = statistics.spectra(0);
  const double dk = along_x.wave_number_step, mean = flow.place(4);
  for (std::size_t n = 0; n < along_x.modes; ++n) {
    EXPECT_NEAR(energy[n] * dk, n == 0 ? mean * mean : n == 2 ? statistics.mean("uu")[4] : 0, 1e-14);
    EXPECT_NEAR(energy[along_x.modes + n] * dk, n == 2 ? statistics.mean("vv")[4] : 0, 1e-14);
  }
  const std::vector<double> of_z = statistics.spectra(1);  // nothing varies along z
  EXPECT_NEAR(of_z[0] * statistics.places()[1].wave_number_step, mean * mean + statistics.mean("uu")[4], 1e-14);
  EXPECT_NEAR(of_z[1], 0, 1e-14);
}

TEST(FlowStatistics, OneHomogeneousAxisLeavesAPlane) {
  FrozenFlow<3> flow;
  FlowStatistics<3> statistics(flow.grid(), {.take = true, .axes = {"z"}});
  statistics.begin();
  statistics.observe(1, 1, flow.set(1));
  ASSERT_EQ(statistics.bins().count(), 12U * 9U);
  const double x = 3.5 * flow.grid().spacing()[0];
  EXPECT_NEAR(statistics.mean("v")[4 * 12 + 3], flow.b * std::cos(2 * flow.k * x + 1), 1e-14);
  EXPECT_NEAR(statistics.mean("vv")[4 * 12 + 3], 0, 1e-14);
}

TEST(FlowStatistics, RefusesWhatIsNotHomogeneous) {
  const FrozenFlow<3> flow;
  const auto make = [&](const StatisticsOptions& options) { FlowStatistics<3>(flow.grid(), options).begin(); };
  EXPECT_THROW(make({.take = true, .axes = {"y"}}), InputError);
  EXPECT_THROW(make({.take = true, .axes = {"r"}}), InputError);
  EXPECT_THROW(make({.take = true, .axes = {"z"}, .spectra = {0.5}}), InputError);
  EXPECT_THROW(make({.take = true, .spectra = {2}}), InputError);
}

}  // namespace
}  // namespace washfsi::test
