// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/options.hpp"

#include "washfsi/simulation/presets.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

RunOptions RunOptions::from_options(Options& options, const std::string& case_name, const Refinement& refinement) {
  RunOptions run;
  run.case_name = case_name;
  options.block("", "Run", [&](OptionBlock& block) {
    declare_preset(block);
    block.require("time_end", "the time at which the run ends, in s");
    block.real("time_step", run.time_step, "s", non_negative,
               "length of a step, the longest if -time_cfl is given too; 0: half of the cloth's bound, if the coupling "
               "has one, or a CFL number of -time_cfl, 0.3 without it, the shorter");
    block.real("time_cfl", run.time_cfl, "-", non_negative,
               "choose each step for this CFL number; 0: steps of equal length");
    block.real(
        "time_tolerance", run.time_tolerance, "-", {0.0, 1.0, false, "a number from 0 to 1"},
        "with -time_cfl, choose each step so that the cloths' velocities err by this part of the largest speed at "
        "most; 0: do not look");
    block.real("time_end", run.time_end, "s", positive, "time at which the run ends");
    block.integer("max_steps", run.max_steps, non_negative_integer, "stop after so many steps; 0: no limit");
    block.real("rest_speed", run.rest_speed, "m/s", non_negative,
               "end early when every marker, after one has been as fast, has been slower for ten steps; 0: do not");
    block.real("time_max_cfl", run.max_courant, "-", positive, "a run whose CFL number exceeds this has diverged");
    block.text("case_name", run.case_name, "in the banner and the summary; unless given that of the last options file");
    block.text("output_dir", run.output_dir, "folder for the results");
    block.real("history_interval", run.history_interval, "s", non_negative,
               "between rows of the history, for which all is measured; 0: every step");
    block.real("output_interval", run.output_interval, "s", non_negative,
               "between frames of the series; 0: a twentieth of the run");
    block.real("checkpoint_interval", run.checkpoint_interval, "s", non_negative,
               "between checkpoints; 0: a tenth of the run");
    block.file("restart", run.restart, "checkpoint file to go on from");
    block.boolean("check", run.check, "only check: set everything up, write it at t = 0 and tell its cost");
    block.boolean("strict", run.strict, "what the program warns of at the start is an error");
  });
  refinement.divide(options, "time_step", run.time_step);
  if (run.time_step > run.time_end && run.time_cfl == 0)
    throw InputError("-time_step " + to_text(run.time_step) + ": must be at most -time_end " + to_text(run.time_end));
  if (run.time_cfl >= run.max_courant)
    throw InputError("-time_cfl " + to_text(run.time_cfl) + ": must be below -time_max_cfl " +
                     to_text(run.max_courant));
  if (run.time_tolerance > 0 && run.time_cfl == 0)
    throw InputError("-time_tolerance " + to_text(run.time_tolerance) + ": needs -time_cfl, which lets steps vary");
  if (run.output_interval == 0) run.output_interval = run.time_end / 20;
  if (run.checkpoint_interval == 0) run.checkpoint_interval = run.time_end / 10;
  return run;
}

}  // namespace washfsi
