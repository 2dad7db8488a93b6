// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include <mpi.h>

namespace washfsi {

/// Where a run stands after a step.
struct ProgressState {
  long step = 0;
  double time = 0, end = 0;  ///< [s]
  double courant = 0;
  double momentum_iterations = 0, pressure_iterations = 0;  ///< means over the run
};

/// How fast a run advances, by its latest steps: setting up is none, and steps change in length and cost. The first
/// one, whose solvers have nothing to begin with, counts only as long as it is alone.
class Pace {
 public:
  /// Where the steps begin; `wall`: seconds of any clock.
  void begin(double wall, long step, double time);
  /// After each step.
  void advance(double wall, long step, double time);

  double seconds_per_step() const;
  /// Whether enough steps are done to tell what is left.
  bool is_known() const { return now_.step - first_ > 5; }
  /// Until the end, in steps as long as the last one [s].
  double seconds_left(double end) const;

 private:
  struct Place {
    double wall = 0;
    long step = 0;
    double time = 0;
  };
  Place from_, next_, now_;  ///< the pace is that since `from_`, which `next_` becomes when it is old enough
  long first_ = 0;           ///< the step before the first
  double dt_ = 0;            ///< of the last step
};

/// The progress on rank 0's terminal: one line that renews itself, or a plain line every few seconds when piped.
class Progress {
 public:
  explicit Progress(MPI_Comm comm);

  /// Before the first step, which goes on from a time.
  void begin(long step, double time) { pace_.begin(wall_seconds(), step, time); }
  /// After each step; prints if it is time to.
  void show(const ProgressState& state);
  /// Ends the line that renews itself.
  void finish();
  /// Prints a line of its own without spoiling the other.
  void note(const std::string& line);

  double wall_seconds() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool speaks_, on_terminal_;
  bool line_open_ = false;
  Pace pace_;
  Clock::time_point start_, shown_;
};

}  // namespace washfsi
