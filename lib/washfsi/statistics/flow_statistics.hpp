// SPDX-License-Identifier: BSD-3-Clause
//
// With <> the mean over time and along the homogeneous axes,
//   <u_i>,   <u_i' u_j'> = <u_i u_j> - <u_i> <u_j>,   <p>,   <p'p'> = <p p> - <p> <p>
// at cell centres, to which velocities are interpolated first, so that the Reynolds stresses are positive semidefinite.
// Each sample is weighted with the time since the previous one, or since the start.
#pragma once

#include <span>

#include "washfsi/statistics/options.hpp"
#include "washfsi/statistics/spectra.hpp"

namespace washfsi {

template <int Dim>
class FlowStatistics {
 public:
  /// Errors: InputError.
  FlowStatistics(const Grid<Dim>& grid, const StatisticsOptions& options);
  FlowStatistics(const FlowStatistics&) = delete;
  FlowStatistics& operator=(const FlowStatistics&) = delete;

  /// The state carried from step to step, for the checkpoint. The same on all ranks.
  std::span<double> kept() { return numbers_; }
  /// Call it before the first step, or after a restart has filled `kept`; begins anew if that is of other statistics.
  void begin();
  /// Call it after a step of dt that ends at a time; takes a sample of `flow` if one is due. Collective.
  void observe(double time, double dt, const FlowMoment& flow);

  const Grid<Dim>& grid() const { return grid_; }
  double start() const { return options_.start; }               ///< [s]
  double averaged_time() const { return numbers_[weight_at]; }  ///< [s]
  const Bins<Dim>& bins() const { return bins_; }
  /// A mean or stress by its name, bin by bin: "u", "p", "uv", "pp" ...; 0 before the first sample.
  std::vector<double> mean(const std::string& name) const;
  const std::vector<SpectrumPlace>& places() const { return places_; }
  /// The mean spectra at a place, component by component [m3/s2].
  std::vector<double> spectra(std::size_t place) const;

 private:
  static constexpr std::size_t weight_at = 0, waiting_at = 1, key_at = 2;  // in `numbers_`
  std::vector<double> key() const;
  std::size_t moments_begin() const { return key_at + key().size(); }
  std::size_t spectra_begin() const;
  double over_weight(double sum) const { return averaged_time() > 0 ? sum / averaged_time() : 0; }
  void sample(double weight, const FlowMoment& flow);

  const Grid<Dim>& grid_;
  StatisticsOptions options_;
  Bins<Dim> bins_;
  std::vector<SpectrumPlace> places_;
  std::vector<double> numbers_;  ///< weight, time since the last sample, key, sums of moments, sums of spectra
};

extern template class FlowStatistics<2>;
extern template class FlowStatistics<3>;

}  // namespace washfsi
