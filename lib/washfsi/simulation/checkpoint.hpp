// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/measure/measures.hpp"

namespace washfsi {

/// The state of a run, beside the clock.
struct RunState {
  double dt = 0;           ///< length of the step [s]
  double cloth_bound = 0;  ///< bound of the step by the cloth, at the last step's places [s]; 0: not known
  int steps_at_rest = not_moved;
  static constexpr int not_moved = -1;  ///< no marker has yet been as fast as -rest_speed
  std::string options;                  ///< `case_options` of the run that wrote it
};

/// Writes the complete state to FOLDER/checkpoint.h5, under another name first, so that the last good one is never
/// lost. Collective. Errors: FileError.
template <int Dim>
void write_checkpoint(const std::string& folder, System<Dim>& system, Measures<Dim>& measures, RunState& run);

/// Restores the state from a checkpoint, written on any number of ranks. Collective.
/// Errors: InputError naming -restart if the file is unreadable or of another grid or cloth.
template <int Dim>
RunState read_checkpoint(const std::string& path, System<Dim>& system, Measures<Dim>& measures);

}  // namespace washfsi
