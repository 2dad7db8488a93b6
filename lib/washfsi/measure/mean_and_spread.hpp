// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace washfsi {

/// Means and standard deviations of several figures over samples that come one by one.
class MeanAndSpread {
 public:
  explicit MeanAndSpread(std::size_t figures) : means_(figures, 0.0), squares_(figures, 0.0) {}

  /// Adds a sample: one value of each figure.
  void add(const std::vector<double>& values);
  /// Begins anew, without samples.
  void forget();

  long count() const { return static_cast<long>(count_); }  ///< samples so far

  struct Mean {
    double mean = 0, deviation = 0;  ///< standard deviation of a sample; 0 of one
  };
  Mean of(std::size_t figure) const;

  /// The number that a restart needs, to read and to set: how many samples there are.
  double& kept_count() { return count_; }
  /// Numbers of each figure that a restart needs, to read and to set, with the ends of their names.
  std::array<std::pair<const char*, std::span<double>>, 2> kept();

 private:
  double count_ = 0;
  std::vector<double> means_, squares_;  ///< mean of each figure, and sum of squares of deviations from it
};

}  // namespace washfsi
