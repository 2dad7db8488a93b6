// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/immersed_boundary/kernel_moments.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

constexpr int points_a_cell = 50;
constexpr double fourth_powers = 2.0 / 3;       // sum over a normal's components, mean over directions, 3/4 to 3/5
constexpr int depths_a_cell = 20, deepest = 3;  // beyond it the sides of a part act independently [cells]

}  // namespace

KernelMoments::KernelMoments(DeltaKernel kernel, double width) : width_(width), spacing_(1.0 / points_a_cell) {
  const int reach = static_cast<int>(width * points_a_cell);
  std::vector<double> density;
  for (int i = -reach; i <= reach; ++i) {
    const double s = i * spacing_;
    density.push_back(spacing_ * regularised_delta(kernel, s, width));
    variance_ += density.back() * s * s;
  }
  weights_.assign(2 * density.size() - 1, 0.0);
  for (std::size_t i = 0; i < density.size(); ++i)
    for (std::size_t j = 0; j < density.size(); ++j) weights_[i + j] += density[i] * density[j];
  sheet_reach_ = mean_difference(0);
  mean_distance_ = sheet_reach_ + fourth_powers / 6 * overlap(0);
  for (int n = 0; n <= depths_a_cell * deepest; ++n) {
    const double b = static_cast<double>(n) / depths_a_cell;
    double lower = 0, upper = b;
    if (acting_half_thickness(0) < b)
      for (int halving = 0; halving < 40; ++halving) {
        const double d = 0.5 * (lower + upper);
        (acting_half_thickness(d) < b ? lower : upper) = d;
      }
    by_depth_.push_back(b - lower);
  }
}

double KernelMoments::overlap(double shift) const {
  const double place = std::abs(shift) / spacing_ + 0.5 * static_cast<double>(weights_.size() - 1);
  const auto n = static_cast<std::size_t>(place);
  if (n + 1 >= weights_.size()) return 0;
  return (weights_[n] + (place - static_cast<double>(n)) * (weights_[n + 1] - weights_[n])) / spacing_;
}

// <|shift + y - y'|> on a grid
double KernelMoments::mean_difference(double shift) const {
  const double middle = 0.5 * static_cast<double>(weights_.size() - 1);
  double sum = 0;
  for (std::size_t i = 0; i < weights_.size(); ++i)
    sum += weights_[i] * std::abs(shift + (static_cast<double>(i) - middle) * spacing_);
  return sum - fourth_powers / 6 * overlap(shift);
}

double KernelMoments::retraction(double half_thickness) const {
  const double place = std::min(half_thickness * depths_a_cell, static_cast<double>(by_depth_.size() - 1) - 1e-9);
  const auto n = static_cast<std::size_t>(place);
  return by_depth_[n] + (place - static_cast<double>(n)) * (by_depth_[n + 1] - by_depth_[n]);
}

}  // namespace washfsi
