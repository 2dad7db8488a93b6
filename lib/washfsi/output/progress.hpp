// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include <mpi.h>

namespace washfsi {

/// The progress of a run after a step.
struct ProgressState {
  long step = 0;
  double time = 0, end = 0;  ///< [s]
  double courant = 0;
  double momentum_iterations = 0, pressure_iterations = 0;  ///< means over the run
};

/// The pace of a run, from its latest steps: set-up does not count, and steps change in length and cost. The first
/// step, whose solvers start without guesses, counts only as long as there is no other.
class Pace {
 public:
  /// Call it before the first step; `wall` are seconds of any clock.
  void begin(double wall, long step, double time);
  /// Call it after each step.
  void advance(double wall, long step, double time);

  double seconds_per_step() const;
  /// Whether enough steps are done to estimate the remaining time.
  bool is_known() const { return now_.step - first_ > 5; }
  /// Estimated time until the end, in steps as long as the last one [s].
  double seconds_left(double end) const;

 private:
  struct Place {
    double wall = 0;
    long step = 0;
    double time = 0;
  };
  Place from_, next_, now_;  ///< the pace is that since `from_`, which `next_` becomes when it is old enough
  long first_ = 0;           ///< the step before the first
  double dt_ = 0;            ///< length of the last step [s]
};

/// The progress on rank 0's terminal: one line that renews itself, or a plain line every few seconds when piped.
class Progress {
 public:
  explicit Progress(MPI_Comm comm);

  /// Call it before the first step, with step and time at the start.
  void begin(long step, double time) { pace_.begin(wall_seconds(), step, time); }
  /// Call it after each step; prints if it is due.
  void show(const ProgressState& state);
  /// Ends the renewing line.
  void finish();
  /// Prints a line of its own without spoiling the renewing one.
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
