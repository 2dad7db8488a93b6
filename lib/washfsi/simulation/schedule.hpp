// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/simulation/checkpoint.hpp"
#include "washfsi/simulation/options.hpp"
#include "washfsi/support/clock.hpp"

namespace washfsi {

/// When a run measures all, when it writes, and when it ends.
class Schedule {
 public:
  /// Both must outlive it; it counts the state's steps at rest.
  Schedule(const RunOptions& run, RunState& state) : run_(run), state_(state) {}

  /// Sets the step with which this start of the program goes on, from which -max_steps counts; else 0.
  void begin(long step) { first_step_ = step; }
  /// Number of steps that this start of the program has taken.
  long steps_taken(const Clock& now) const { return now.step - first_step_; }

  /// Whether a multiple of the interval [s] lies in the step that ends at a time [s].
  bool due(double interval, double time) const;
  /// Whether all is measured after the step that ends then, which may turn out to be the last one at rest.
  bool measures_all(const Clock& after) const;
  /// Whether the run ends: enough time or steps have passed, or the cloths are at rest.
  bool finished(const Clock& now) const { return ends(now, state_.steps_at_rest); }

  /// Counts the steps at rest for -rest_speed; call it after each step. Collective.
  template <int Dim>
  void watch_rest(const System<Dim>& system);

 private:
  bool ends(const Clock& now, int steps_at_rest) const;

  const RunOptions& run_;
  RunState& state_;
  long first_step_ = 0;
};

extern template void Schedule::watch_rest<2>(const System<2>&);
extern template void Schedule::watch_rest<3>(const System<3>&);

}  // namespace washfsi
