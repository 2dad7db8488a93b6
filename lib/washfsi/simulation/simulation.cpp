// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "washfsi/simulation/changed_options.hpp"
#include "washfsi/simulation/doubtful_options.hpp"
#include "washfsi/simulation/idle_options.hpp"
#include "washfsi/simulation/report_lines.hpp"
#include "washfsi/simulation/size_check.hpp"
#include "washfsi/simulation/step_checks.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/hdf5_file.hpp"
#include "washfsi/support/long_task.hpp"
#include "washfsi/trust/end_findings.hpp"

namespace washfsi {

namespace {

template <int Dim>
std::vector<Body<Dim>> prepared_bodies(Options& options, const GridShape<Dim>& shape) {
  const LongTask task(options.comm(), "preparing the bodies");
  return bodies_from_options<Dim>(options, shape.spacing().minCoeff());
}

template <int Dim>
ProgressState progress_of(const System<Dim>& system, double courant, double end) {
  const Clock& clock = system.state.clock;
  const auto steps = static_cast<double>(clock.step);
  return {.step = clock.step,
          .time = clock.time,
          .end = end,
          .courant = courant,
          .momentum_iterations = system.model.fluid.counts().momentum / steps,
          .pressure_iterations = system.model.fluid.counts().pressure / steps};
}

}  // namespace

template <int Dim>
Simulation<Dim>::Simulation(Options& options, const std::string& case_name) : progress_(options.comm()) {
  const Refinement refinement = Refinement::from_options(options);
  run_ = RunOptions::from_options(options, case_name, refinement);
  const auto chosen = CaseOptions<Dim>::from_options(options, refinement);
  const GridShape<Dim>& shape = chosen.model.grid.shape;
  std::vector<Body<Dim>> bodies = prepared_bodies<Dim>(options, shape);
  mark_idle_options<Dim>(options, chosen, bodies);
  warn_of_doubtful_options<Dim>(options, chosen, bodies);
  std::vector<Profile<Dim>> profiles = profiles_from_options<Dim>(options, shape.lower, shape.upper);
  if (options.help()) return;

  refuse_what_cannot_fit<Dim>(options.comm(), chosen);
  system_ = start_system<Dim>(options.comm(), chosen, std::move(bodies));
  const LongTask task(options.comm(), "preparing the coupling, the measures and the start");
  set_up(options, chosen);
  open_folder(options);
  start_results(options.comm(), std::move(profiles));
}

template <int Dim>
void Simulation<Dim>::set_up(Options& options, const CaseOptions<Dim>& chosen) {
  start_.coupling = system_->model.has_fluid ? chosen.coupling.scheme : "to nothing";
  scheme_ = make_coupling_scheme<Dim>(chosen.coupling, *system_);
  steps_ = std::make_unique<TimeStepControl<Dim>>(run_, chosen.coupling, *system_, *scheme_);
  measures_ = std::make_unique<Measures<Dim>>(*system_, chosen.measure);
  start_.findings = judge_start(*system_, *measures_, run_, chosen);
  if (!run_.restart.empty()) go_on_from_checkpoint(options.comm());
  measures_->verify_start();
  steps_->begin(state_);
  take_notes(options);
}

template <int Dim>
void Simulation<Dim>::go_on_from_checkpoint(MPI_Comm comm) {
  state_ = read_checkpoint<Dim>(run_.restart, *system_, *measures_);
  schedule_.begin(clock().step);
  std::error_code other;
  if (std::filesystem::equivalent(run_.restart, run_.output_dir + "/checkpoint.h5", other)) kept_step_ = clock().step;
  if (schedule_.finished(clock()) && Results<Dim>::holds_an_end(comm, run_.output_dir))
    throw InputError("-time_end " + to_text(run_.time_end) +
                     ": must be later than the checkpoint of -restart, which is at " + to_text(clock().time) + " s");
}

// Takes the notes on the options, all of which have been read. Where a restart changes the case, the means over cycles
// begin anew.
template <int Dim>
void Simulation<Dim>::take_notes(Options& options) {
  if (run_.time_cfl == 0) options.record("time_step", to_text(state_.dt));
  warn_of_short_spans<Dim>(options, *measures_, state_.dt);
  options.reject_unread();
  start_.notes = options.notes();
  const std::string now = case_options(options.resolved());
  const std::vector<std::string> changes = changed_options(state_.options, now);
  start_.notes.insert(start_.notes.end(), changes.begin(), changes.end());
  if (!changes.empty()) measures_->cycles().forget_means();
  state_.options = now;
}

template <int Dim>
void Simulation<Dim>::open_folder(const Options& options) {
  make_writable_folder(options.comm(), run_.output_dir);
  if (run_.check && Results<Dim>::holds_a_run(options.comm(), run_.output_dir)) {
    run_.output_dir += "/check";  // a check must not spoil the results of a run
    make_writable_folder(options.comm(), run_.output_dir);
  }
  lock_ = std::make_unique<FolderLock>(options.comm(), run_.output_dir);
  if (rank_of(options.comm()) == 0) remove_parts(run_.output_dir);
  write_text_file(options.comm(), run_.output_dir + "/resolved.opts", repeatable(options.resolved()));
}

template <int Dim>
void Simulation<Dim>::start_results(MPI_Comm comm, std::vector<Profile<Dim>> profiles) {
  const long continues_from = run_.restart.empty() || run_.check ? -1 : clock().step;
  if (continues_from < 0 && !run_.check) Results<Dim>::remove_ends(comm, run_.output_dir);
  if (continues_from >= 0) Results<Dim>::remove_summary(comm, run_.output_dir);
  results_ = std::make_unique<Results<Dim>>(*system_, *measures_, std::move(profiles), run_.output_dir, continues_from);
  if (!run_.check) results_->open_history(continues_from);
  Model<Dim>& model = system_->model;
  model.liquid.let_models_add({model.fluid.velocity(), clock().time, model.bodies.fluid_share()});
  measures_->observe_start(state_.dt);
  results_->write_frame(clock().step);
}

template <int Dim>
void Simulation<Dim>::run() {
  if (!system_) return;  // -help
  print_banner();
  if (run_.strict) refuse_doubts(start_);
  if (run_.check) return check_only();
  const StopSignals signals;
  try {
    bool stopped = false;
    progress_.begin(clock().step, clock().time);
    while (!schedule_.finished(clock()) && !stopped) {
      step();
      stopped = signals.requested(system_->model.grid.comm());
    }
    save_checkpoint();
    end(stopped ? "stopped" : "finished");
  } catch (const DivergedError& error) {
    end("failed");
    throw DivergedError("diverged in step " + std::to_string(attempt_.step) +
                        " after t = " + format_text("%.6g", attempt_.start) + " s: " + error.what() + "; " +
                        where_it_failed(system_->model, measures_->flow().courant));
  }
}

template <int Dim>
void Simulation<Dim>::step() {
  if (clock().step > 0) steps_->adapt(state_, measures_->flow().courant.value);
  attempt_ = {clock().step + 1, clock().time};
  Clock after = clock();
  after.advance(state_.dt);
  if (steps_->may_shorten() || schedule_.measures_all(after)) measures_->prepare();
  steps_->advance(state_);
  const bool all = schedule_.measures_all(clock());
  observe(all);
  write_due(all);
  if (clock().step % 50 == 0) watch_step_bound();
  progress_.show(progress_of(*system_, measures_->flow().courant.value, run_.time_end));
}

template <int Dim>
void Simulation<Dim>::observe(bool all) {
  check_markers(*system_);  // before anything is measured: crossings look at all space between a cloth's markers
  measures_->verify(state_.dt);
  measures_->observe(state_.dt, all);
  check_velocity(measures_->flow().courant, run_);
  schedule_.watch_rest(*system_);
  if (run_.time_cfl > 0) steps_->find_cloth_bound(state_);
}

template <int Dim>
void Simulation<Dim>::write_due(bool all) {
  if (all) results_->write_row(clock().step);
  if (schedule_.due(run_.output_interval, clock().time)) results_->write_frame(clock().step);
  if (schedule_.due(run_.checkpoint_interval, clock().time)) save_checkpoint();
}

// Writes a checkpoint, once per step, so that the previous one is of an earlier step.
template <int Dim>
void Simulation<Dim>::save_checkpoint() {
  if (clock().step == kept_step_) return;
  kept_step_ = clock().step;
  write_checkpoint<Dim>(run_.output_dir, *system_, *measures_, state_);
}

template <int Dim>
void Simulation<Dim>::watch_step_bound() {
  if (warned_of_step_) return;
  const double bound = scheme_->step_bound(*system_);
  if (state_.dt <= bound) return;
  warned_of_step_ = true;
  progress_.note(
      format_text("warning: -time_step %.3g s exceeds the bound %.3g s of the coupling for the cloth as it"
                  " lies at t = %.4g s",
                  state_.dt, bound, clock().time));
}

template <int Dim>
void Simulation<Dim>::print_banner() {
  const Model<Dim>& model = system_->model;
  for (const std::string& note : start_.notes) progress_.note(note);
  for (const std::string& line : banner_lines(model, run_.case_name, start_.coupling)) progress_.note(line);
  const double bound = scheme_->step_bound(*system_);
  progress_.note(time_line(state_.dt, run_.time_end, bound, model.cloths.marker_count() > 0));
  for (const std::string& line : demonstration_lines(measures_->cycles(), run_.time_end)) progress_.note(line);
  for (const std::string& line : trust_lines(start_.findings, run_.check)) progress_.note(line);
  watch_step_bound();
}

template <int Dim>
void Simulation<Dim>::check_only() {
  const double memory = peak_memory(system_->model.grid.comm());
  const double start = clock().time;
  constexpr int trial_steps = 3;
  scheme_->advance(*system_, state_.dt);  // the first step sets up what later ones reuse
  const double before = progress_.wall_seconds();
  for (int n = 0; n < trial_steps; ++n) scheme_->advance(*system_, state_.dt);  // only to time them
  const double per_step = (progress_.wall_seconds() - before) / trial_steps;
  const double steps = std::ceil((run_.time_end - start) / state_.dt - 1e-6);
  progress_.note(format_text("  memory    about %.0f MB", memory / 1e6));
  progress_.note(
      format_text("  duration  about %.0f s: %.0f steps of %.1f ms", steps * per_step, steps, 1e3 * per_step));
  progress_.note(format_text("check passed; the state at t = %.6g s is in ", start) + run_.output_dir);
}

template <int Dim>
RunSummary Simulation<Dim>::summarised(const std::string& status) const {
  RunSummary summary;
  summary.case_name = run_.case_name;
  summary.status = status;
  summary.steps = clock().step;
  summary.time = clock().time;
  summary.wall_seconds = progress_.wall_seconds();
  summary.seconds_per_step = summary.wall_seconds / static_cast<double>(std::max(1L, schedule_.steps_taken(clock())));
  summary.at_start = start_.findings;
  return summary;
}

template <int Dim>
void Simulation<Dim>::end(const std::string& status) {
  progress_.finish();
  RunSummary summary = summarised(status);
  if (status != "failed") {
    results_->write_frame(clock().step);
    results_->write_final();
  }
  summary.at_end = end_findings(*system_, *measures_, run_.time_cfl);
  results_->write_summary(summary);
  for (const std::string& line : end_lines(*system_, *measures_, summary, run_.output_dir)) progress_.note(line);
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace washfsi
