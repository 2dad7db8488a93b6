// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/flow_statistics.hpp"

#include <algorithm>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
FlowStatistics<Dim>::FlowStatistics(const Grid<Dim>& grid, const StatisticsOptions& options)
    : grid_(grid),
      options_(options),
      bins_(grid, options.axes),
      places_(spectrum_places<Dim>(grid, bins_, options.spectra)) {
  std::size_t size = spectra_begin();
  for (const SpectrumPlace& place : places_) size += Dim * place.modes;
  numbers_.assign(size, 0.0);
}

// The key that distinguishes these statistics from others with as many numbers.
template <int Dim>
std::vector<double> FlowStatistics<Dim>::key() const {
  std::vector<double> key(Dim + 1 + places_.size(), 0.0);
  for (int d = 0; d < Dim; ++d) key[static_cast<std::size_t>(d)] = bins_.is_homogeneous(d) ? 1 : 2;
  key[Dim] = options_.start;
  for (std::size_t n = 0; n < places_.size(); ++n) key[Dim + 1 + n] = places_[n].height;
  return key;
}

template <int Dim>
std::size_t FlowStatistics<Dim>::spectra_begin() const {
  return moments_begin() + bins_.count() * moment_names<Dim>().size();
}

template <int Dim>
void FlowStatistics<Dim>::begin() {
  keep_if_same(numbers_, key_at, key());
}

template <int Dim>
void FlowStatistics<Dim>::observe(double time, double dt, const FlowMoment& flow) {
  const double weight = Sampling{options_.start, options_.interval}.due(time, dt, numbers_[waiting_at]);
  if (weight > 0) sample(weight, flow);
}

template <int Dim>
void FlowStatistics<Dim>::sample(double weight, const FlowMoment& flow) {
  numbers_[weight_at] += weight;
  auto sum = numbers_.begin() + static_cast<std::ptrdiff_t>(moments_begin());
  for (const double value : bin_means<Dim>(grid_, bins_, flow)) *sum++ += weight * value;
  for (const SpectrumPlace& place : places_)
    for (const double value : spectra_of<Dim>(grid_, place, flow.velocity)) *sum++ += weight * value;
}

template <int Dim>
std::vector<double> FlowStatistics<Dim>::mean(const std::string& name) const {
  const std::vector<std::string> names = moment_names<Dim>();
  const auto position = [&](const std::string& wanted) {
    return static_cast<std::size_t>(std::ranges::find(names, wanted) - names.begin());
  };
  std::vector<double> means;
  for (std::size_t bin = 0; bin < bins_.count(); ++bin) {
    const auto at = [&](std::size_t n) { return over_weight(numbers_[moments_begin() + bin * names.size() + n]); };
    double value = at(position(name));
    if (name.size() == 2) value -= at(position(name.substr(0, 1))) * at(position(name.substr(1)));
    means.push_back(value);
  }
  return means;
}

template <int Dim>
std::vector<double> FlowStatistics<Dim>::spectra(std::size_t place) const {
  std::size_t begin = spectra_begin();
  for (std::size_t n = 0; n < place; ++n) begin += Dim * places_[n].modes;
  std::vector<double> means;
  for (std::size_t n = 0; n < Dim * places_[place].modes; ++n) means.push_back(over_weight(numbers_[begin + n]));
  return means;
}

template class FlowStatistics<2>;
template class FlowStatistics<3>;

}  // namespace washfsi
