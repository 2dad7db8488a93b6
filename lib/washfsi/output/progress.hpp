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

/// The progress on rank 0's terminal: one line that renews itself, or a plain line every few seconds when piped.
class Progress {
 public:
  explicit Progress(MPI_Comm comm);

  /// Prints if it is time to.
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
  long first_step_ = -1;
  Clock::time_point start_, shown_;
};

}  // namespace washfsi
