// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace washfsi {

/// When samples are taken: after steps, from a time on.
struct Sampling {
  double start = 0;     ///< [s]
  double interval = 0;  ///< between samples [s]; 0: each step

  /// The time [s] for which a sample stands that is due after a step of dt which ends at a time; 0 if none is due.
  /// `waiting` goes on from step to step: the time since the sample before, or since the start [s].
  double due(double time, double dt, double& waiting) const;
};

/// Numbers that a checkpoint has filled begin anew, as zeros, unless they are of the statistics with this key, which is
/// in its place among them then.
void keep_if_same(std::span<double> numbers, std::size_t key_at, std::span<const double> key);

}  // namespace washfsi
