// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/ring_sums.hpp"

#include <algorithm>

#include "washfsi/grid/cell_share.hpp"
#include "washfsi/grid/cell_velocity.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr std::size_t weight_at = 0, aside_at = 1, aside_squared_at = 2, velocity_at = 3, slope_at = 6, square_at = 9,
                      dissipation_at = 10, model_at = 11;

// 2 mu e:e of a cell over the viscosity's scale: what stretches the cell, and a quarter of the shear on each edge round
// it. Over all cells it adds up to what `FlowDiagnostics` has.
template <class Form>
double squared_strain(const ConstFaceView<3>& u, const Form& mu, const Index<3>& cell, const Spacing<3>& h) {
  double sum = 0;
  for_each_component<3>([&](auto c) {
    const double stretched = stretching<3>(u, cell, c, h);
    sum += mu.in_cell(cell) * 2 * stretched * stretched;
    for_each_component<3>([&](auto d) {
      if constexpr (d < c)
        for (int corner = 0; corner < 4; ++corner) {
          const Index<3> edge = shifted<3>(shifted<3>(cell, c, corner % 2), d, corner / 2);
          const double sheared = shear_rate<3>(u, edge, c, d, h);
          sum += 0.25 * mu.on_edge(edge, c, d) * sheared * sheared;
        }
    });
  });
  return sum;
}

/// Dissipation by the pure liquid's viscosity, and by that of models [m2/s3].
struct Dissipation {
  double pure, model;
};

// Calls use with the dissipation as a function of a cell's index.
template <class Use>
void with_dissipation(const Grid<3>& grid, const ConstFaceView<3>& u, const LiquidMoment& flow, Use&& use) {
  const Spacing<3> h(grid.spacing());
  const UniformViscosity<3> one(grid, 1);
  const double kinematic = flow.pure_viscosity / flow.density;
  if (!flow.viscosity.in_cells)
    return use([&](const Index<3>& cell) { return Dissipation{kinematic * squared_strain(u, one, cell, h), 0}; });
  const CellViscosity<3> with_models(grid, flow.viscosity);
  use([&](const Index<3>& cell) {
    const double pure = kinematic * squared_strain(u, one, cell, h);
    return Dissipation{pure, squared_strain(u, with_models, cell, h) / flow.density - pure};
  });
}

void add_velocity(double* sums, double weight, double aside, const Point<3>& velocity) {
  sums[weight_at] += weight;
  sums[aside_at] += weight * aside;
  sums[aside_squared_at] += weight * aside * aside;
  for (int c = 0; c < 3; ++c) {
    sums[velocity_at + static_cast<std::size_t>(c)] += weight * velocity[c];
    sums[slope_at + static_cast<std::size_t>(c)] += weight * aside * velocity[c];
  }
}

}  // namespace

std::vector<double> ring_sums(const Grid<3>& grid, const RingBins& bins, const LiquidMoment& flow) {
  const ConstFaceView<3> u(grid.face_dm(), flow.velocity);
  const CellShare<3> share(grid, flow.fluid_share);
  std::vector<double> sums(bins.count() * ring_sum_count, 0.0);
  with_dissipation(grid, u, flow, [&](const auto& dissipation) {
    for_each<3>(grid.owned(), [&](const Index<3>& cell) {
      const double weight = share(cell);
      if (weight <= 0) return;
      const RingBins::Place place = bins.at(grid.cell_center(cell));
      Point<3> velocity;
      for (int c = 0; c < 3; ++c) velocity[c] = cell_velocity<3>(u, cell, c);
      double* ring = &sums[place.bin * ring_sum_count];
      add_velocity(ring, weight, place.aside, bins.along(place, velocity));
      ring[square_at] += weight * velocity.squaredNorm();
      const Dissipation lost = dissipation(cell);
      ring[dissipation_at] += weight * lost.pure;
      ring[model_at] += weight * lost.model;
    });
  });
  return ordered_sum(grid.comm(), sums);
}

// The variance is that about a mean that is linear in R, so that a mean flow which changes over the width of a ring is
// not taken for turbulence.
RingMeans RingMeans::of(std::span<const double, ring_sum_count> sums) {
  const auto mean = [&](std::size_t n) { return sums[n] / sums[weight_at]; };
  RingMeans means;
  means.liquid = sums[weight_at];
  means.velocity = {mean(velocity_at), mean(velocity_at + 1), mean(velocity_at + 2)};
  const double aside = mean(aside_at), spread = mean(aside_squared_at) - aside * aside;
  constexpr double no_spread = 1e-9;  // of squared widths: all cells are as far from the axis
  double variance = mean(square_at) - means.velocity.squaredNorm();
  if (spread > no_spread) {
    const Point<3> together(mean(slope_at), mean(slope_at + 1), mean(slope_at + 2));
    variance -= (together - aside * means.velocity).squaredNorm() / spread;
  }
  means.turbulence_energy = variance < 0 ? 0 : 0.5 * variance;  // negative only by rounding; may be NaN
  means.dissipation = mean(dissipation_at);
  means.model_dissipation = mean(model_at);
  return means;
}

}  // namespace washfsi
