// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/support/refinement.hpp"

namespace washfsi {

/// The run itself: time, output folder, intervals, restart.
struct RunOptions {
  std::string case_name;      ///< name in the banner and the summary
  double time_step = 0;       ///< length of steps [s], the longest if time_cfl is given too; 0: the program's choice
  double time_cfl = 0;        ///< choose each step for this CFL number; 0: steps of equal length
  double time_tolerance = 0;  ///< choose each step for this `step_error` too; 0: do not
  double time_end = 1;        ///< end of the run [s]
  PetscInt max_steps = 0;     ///< most steps; 0: no limit
  double rest_speed = 0;      ///< end when all markers have been slower for some steps [m/s]; 0: do not
  double max_courant = 1;     ///< CFL number beyond which a run has diverged
  std::string output_dir = "out";
  double history_interval = 0;     ///< [s]; 0: every step
  double output_interval = 0;      ///< [s]; 0: a twentieth of the run
  double checkpoint_interval = 0;  ///< [s]; 0: a tenth of the run
  std::string restart;             ///< checkpoint file; empty: from the start
  bool check = false;              ///< dry run
  bool strict = false;             ///< refuse a case with warnings

  /// `case_name` is the default. Errors: InputError. Collective.
  static RunOptions from_options(Options& options, const std::string& case_name, const Refinement& refinement);
};

}  // namespace washfsi
