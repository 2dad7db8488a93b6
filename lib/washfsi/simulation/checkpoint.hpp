// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/measure/measures.hpp"

namespace washfsi {

/// Where a run stands, beside the clock.
struct RunState {
  double dt = 0;           ///< [s]
  double cloth_bound = 0;  ///< of the step, at the last step's places [s]; 0: not known
  int steps_at_rest = not_moved;
  static constexpr int not_moved = -1;  ///< no marker has yet been as fast as -rest_speed
  std::string options;                  ///< of the case of the run that wrote it (`case_options`)
};

/// Writes the complete state to FOLDER/checkpoint.h5, under another name first, so that the last good one is never
/// lost. Collective. Errors: FileError.
template <int Dim>
void write_checkpoint(const std::string& folder, System<Dim>& system, Measures<Dim>& measures, RunState& run);

/// Takes the state from a checkpoint, written on any number of ranks. Collective.
/// Errors: InputError naming -restart if the file is unreadable or of another grid or cloth.
template <int Dim>
RunState read_checkpoint(const std::string& path, System<Dim>& system, Measures<Dim>& measures);

}  // namespace washfsi
