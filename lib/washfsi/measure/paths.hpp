// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// The lengths of points' paths, from observation to observation.
template <int Dim>
class Paths {
 public:
  explicit Paths(std::size_t points) : totals_(points, 0.0), ends_(Dim * points, std::numeric_limits<double>::max()) {}

  /// Adds the ways to these places [m] of all points; the first call sets their start.
  void observe(const std::vector<Point<Dim>>& places) {
    for (std::size_t p = 0; p < places.size(); ++p) {
      Eigen::Map<Point<Dim>> end(&ends_[Dim * p]);
      if (end[0] != std::numeric_limits<double>::max()) totals_[p] += (places[p] - end).norm();
      end = places[p];
    }
  }

  /// Lengths so far [m].
  std::span<const double> totals() const { return totals_; }

  /// Numbers that a restart needs, to read and to set.
  std::span<double> totals() { return totals_; }
  std::span<double> ends() { return ends_; }

 private:
  std::vector<double> totals_, ends_;  ///< [m]
};

}  // namespace washfsi
