// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/mean_and_spread.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

// Welford's update of mean and spread.
void MeanAndSpread::add(const std::vector<double>& values) {
  ++count_;
  for (std::size_t n = 0; n < values.size(); ++n) {
    const double off = values[n] - means_[n];
    means_[n] += off / count_;
    squares_[n] += off * (values[n] - means_[n]);
  }
}

void MeanAndSpread::forget() {
  count_ = 0;
  std::ranges::fill(means_, 0.0);
  std::ranges::fill(squares_, 0.0);
}

MeanAndSpread::Mean MeanAndSpread::of(std::size_t figure) const {
  const double deviation = count_ > 1 ? std::sqrt(squares_[figure] / (count_ - 1)) : 0.0;
  return {means_[figure], deviation};
}

std::array<std::pair<const char*, std::span<double>>, 2> MeanAndSpread::kept() {
  return {{{"_means", means_}, {"_squares", squares_}}};
}

}  // namespace washfsi
