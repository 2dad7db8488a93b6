// SPDX-License-Identifier: BSD-3-Clause
//
// Means over the cycles of a machine: over the azimuth round its axis, and over all times of the same phase of the
// period, in bins of the radius and of the place along the axis. Turbulence is the difference from this mean, be it
// along the azimuth, from cycle to cycle, or within the phase. Each sample is weighted with the time since the previous
// one, or since the start, and belongs to the phase in which the middle of this time lies.
#pragma once

#include "washfsi/statistics/options.hpp"
#include "washfsi/statistics/ring_sums.hpp"

namespace washfsi {

class PhaseStatistics {
 public:
  /// The options must have a period, unless of one phase, and a centre. Collective. Errors: InputError.
  PhaseStatistics(const Grid<3>& grid, const PhaseOptions& options);
  PhaseStatistics(const PhaseStatistics&) = delete;
  PhaseStatistics& operator=(const PhaseStatistics&) = delete;

  /// The state carried from step to step, for the checkpoint. The same on all ranks.
  std::span<double> kept() { return numbers_; }
  /// Call it before the first step, or after a restart has filled `kept`; begins anew if that is of other statistics.
  void begin();
  /// Call it after a step of dt that ends at a time [s]; takes a sample of `flow` if one is due. Collective.
  void observe(double time, double dt, const LiquidMoment& flow);

  const Grid<3>& grid() const { return grid_; }
  const RingBins& bins() const { return bins_; }
  const PhaseOptions& options() const { return options_; }
  std::size_t count() const { return static_cast<std::size_t>(options_.count); }  ///< number of phases
  /// The number of samples of a phase, and the time that they stand for [s].
  double samples(std::size_t phase) const { return numbers_[phase_begin(phase)]; }
  double averaged_time(std::size_t phase) const { return numbers_[phase_begin(phase) + 1]; }
  RingMeans means(std::size_t phase, std::size_t bin) const;
  /// The mean share of liquid in a bin; 0 without samples, or where no cell is.
  double liquid_share(std::size_t phase, std::size_t bin) const;

 private:
  static constexpr std::size_t waiting_at = 0, key_at = 1;  // in `numbers_`
  std::vector<double> key() const;
  std::size_t phase_at(double time) const;
  std::size_t phase_begin(std::size_t phase) const;
  std::span<const double, ring_sum_count> sums(std::size_t phase, std::size_t bin) const;

  const Grid<3>& grid_;
  PhaseOptions options_;
  RingBins bins_;
  std::vector<double> numbers_;  ///< time since the last sample, key; for each phase: samples, time, sums of rings
};

}  // namespace washfsi
