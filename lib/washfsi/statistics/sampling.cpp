// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/sampling.hpp"

#include <algorithm>
#include <utility>

namespace washfsi {

double Sampling::due(double time, double dt, double& waiting) const {
  constexpr double rounding = 1e-9;
  waiting += std::clamp(time - start, 0.0, dt);
  if (waiting <= rounding * dt || waiting < (1 - rounding) * interval) return 0;
  return std::exchange(waiting, 0.0);
}

void keep_if_same(std::span<double> numbers, std::size_t key_at, std::span<const double> key) {
  const std::span<double> read = numbers.subspan(key_at, key.size());
  if (!std::ranges::equal(key, read)) std::ranges::fill(numbers, 0.0);
  std::ranges::copy(key, read.begin());
}

}  // namespace washfsi
