// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace washfsi {

/// When samples are taken: after steps, from a time on.
struct Sampling {
  double start = 0;     ///< start of sampling [s]
  double interval = 0;  ///< interval between samples [s]; 0: each step

  /// The time [s] for which a sample stands that is due after a step of dt which ends at a time; 0 if none is due.
  /// `waiting` is carried from step to step: the time since the previous sample, or since the start [s].
  double due(double time, double dt, double& waiting) const;
};

/// Sets numbers from a checkpoint to zero and stores the key in its place among them, unless they already have this
/// key.
void keep_if_same(std::span<double> numbers, std::size_t key_at, std::span<const double> key);

}  // namespace washfsi
