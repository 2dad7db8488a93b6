// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/phase_statistics.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

constexpr std::size_t before_rings = 2;  // numbers of a phase before its rings: samples, time

// An axis that passes the box by has no rings round it.
const PhaseOptions& with_place(const Grid<3>& grid, const PhaseOptions& options) {
  const Point<3>& center = *options.center;
  for (int d = 0; d < 3; ++d)
    if (d != options.axis && !(center[d] >= grid.lower()[d] && center[d] <= grid.upper()[d]))
      throw InputError("-statistics_phase_center " + list_text<3>(center) + ": must lie in the box, from " +
                       list_text<3>(grid.lower()) + " to " + list_text<3>(grid.upper()));
  return options;
}

// Checks that bins are not narrower than a cell: some would contain none.
void check_bins(const Grid<3>& grid, const RingBins& bins, const PhaseOptions& options) {
  const Point<3> h = grid.spacing();
  const double across = std::max(h[(options.axis + 1) % 3], h[(options.axis + 2) % 3]);
  const auto check = [](const char* name, PetscInt asked, double length, double cell) {
    const double most = std::ceil(length / cell - 1e-9);
    if (static_cast<double>(asked) > most)
      throw InputError(std::string("-statistics_phase_bins_") + name + " " + std::to_string(asked) +
                       ": must be at most " + to_text(most) + ", or bins are narrower than cells, and some hold none");
  };
  check("r", options.bins[0], bins.reach(), across);
  check("z", options.bins[1], grid.upper()[options.axis] - grid.lower()[options.axis], h[options.axis]);
}

}  // namespace

PhaseStatistics::PhaseStatistics(const Grid<3>& grid, const PhaseOptions& options)
    : grid_(grid),
      options_(with_place(grid, options)),
      bins_(grid, options.axis, options.center.value(), options.bins) {
  check_bins(grid, bins_, options);
  if (options.period == 0 && options.count > 1)
    throw InputError("-statistics_phase_period is missing: no body moves periodically and there is no -cycle_time");
  constexpr double most = 1e8;  // most numbers on every rank and in the checkpoint
  if (static_cast<double>(count() * bins_.count() * ring_sum_count) > most)
    throw InputError("-statistics_phases " + std::to_string(options.count) + ": too many with " +
                     std::to_string(bins_.count()) + " bins each; at most 1e8 numbers are kept, " +
                     std::to_string(ring_sum_count) + " of each bin");
  numbers_.assign(phase_begin(count()), 0.0);
}

// The key that distinguishes these statistics from others with as many numbers.
std::vector<double> PhaseStatistics::key() const {
  const Point<3>& center = *options_.center;
  return {static_cast<double>(options_.count),
          options_.period,
          options_.sampling.start,
          static_cast<double>(options_.axis),
          center[(options_.axis + 1) % 3],
          center[(options_.axis + 2) % 3],
          static_cast<double>(bins_.radii().size())};
}

std::size_t PhaseStatistics::phase_begin(std::size_t phase) const {
  return key_at + key().size() + phase * (before_rings + bins_.count() * ring_sum_count);
}

void PhaseStatistics::begin() {
  keep_if_same(numbers_, key_at, key());
}

std::size_t PhaseStatistics::phase_at(double time) const {
  if (options_.period == 0) return 0;
  const double within = std::fmod(time, options_.period) / options_.period;
  return std::min(static_cast<std::size_t>(within * static_cast<double>(count())), count() - 1);
}

void PhaseStatistics::observe(double time, double dt, const LiquidMoment& flow) {
  const double weight = options_.sampling.due(time, dt, numbers_[waiting_at]);
  if (weight == 0) return;
  double* number = &numbers_[phase_begin(phase_at(time - 0.5 * weight))];
  *number++ += 1;
  *number++ += weight;
  for (const double value : ring_sums(grid_, bins_, flow)) *number++ += weight * value;
}

std::span<const double, ring_sum_count> PhaseStatistics::sums(std::size_t phase, std::size_t bin) const {
  const std::span<const double> all(numbers_);
  return all.subspan(phase_begin(phase) + before_rings + bin * ring_sum_count).first<ring_sum_count>();
}

RingMeans PhaseStatistics::means(std::size_t phase, std::size_t bin) const {
  return RingMeans::of(sums(phase, bin));
}

double PhaseStatistics::liquid_share(std::size_t phase, std::size_t bin) const {
  const double all = averaged_time(phase) * bins_.cells(bin);
  return all > 0 ? sums(phase, bin)[0] / all : 0;
}

}  // namespace washfsi
