// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "washfsi/coupling/coupling_operations.hpp"
#include "washfsi/simulation/changed_options.hpp"
#include "washfsi/simulation/doubtful_options.hpp"
#include "washfsi/simulation/idle_options.hpp"
#include "washfsi/simulation/report_lines.hpp"
#include "washfsi/simulation/size_check.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/support/hdf5_file.hpp"
#include "washfsi/support/long_task.hpp"
#include "washfsi/trust/end_findings.hpp"
#include "washfsi/trust/start_findings.hpp"

namespace washfsi {

template <int Dim>
Simulation<Dim>::Simulation(Options& options, const std::string& case_name) : progress_(options.comm()) {
  run_ = RunOptions::from_options(options, case_name);
  const auto chosen = CaseOptions<Dim>::from_options(options);
  const GridShape<Dim>& shape = chosen.model.grid.shape;
  std::optional<LongTask> task(std::in_place, options.comm(), "preparing the bodies");
  std::vector<Body<Dim>> bodies = bodies_from_options<Dim>(options, shape.spacing().minCoeff());
  task.reset();
  mark_idle_options<Dim>(options, chosen, bodies);
  warn_of_doubtful_options<Dim>(options, chosen, bodies);
  profiles_ = profiles_from_options<Dim>(options, shape.lower, shape.upper);
  if (options.help()) return;

  refuse_what_cannot_fit<Dim>(options.comm(), chosen);
  system_ = start_system<Dim>(options.comm(), chosen, std::move(bodies));
  task.emplace(options.comm(), "preparing the coupling, the measures and the start");
  coupling_ = system_->model.has_fluid ? chosen.coupling.scheme : "to nothing";
  scheme_ = make_coupling_scheme<Dim>(chosen.coupling, *system_);
  steps_ = std::make_unique<StepChoice<Dim>>(run_, chosen.coupling, *system_, *scheme_);
  measures_ = std::make_unique<Measures<Dim>>(*system_, chosen.measure);
  judge_start(chosen);
  if (!run_.restart.empty()) {
    state_ = read_checkpoint<Dim>(run_.restart, *system_, *measures_);
    first_step_ = clock().step;
    std::error_code other;
    if (std::filesystem::equivalent(run_.restart, run_.output_dir + "/checkpoint.h5", other)) kept_step_ = first_step_;
    if (finished() && Results<Dim>::holds_an_end(options.comm(), run_.output_dir))
      throw InputError("-time_end " + to_text(run_.time_end) +
                       ": must be later than the checkpoint of -restart, which is at " + to_text(clock().time) + " s");
  }
  measures_->verify_start();
  steps_->begin(state_);
  if (run_.time_cfl == 0) options.record("time_step", state_.dt);
  warn_of_short_spans<Dim>(options, *measures_, state_.dt);
  options.reject_unread();
  notes_ = options.notes();
  const std::string now = case_options(options.resolved());
  const std::vector<std::string> changes = changed_options(state_.options, now);
  notes_.insert(notes_.end(), changes.begin(), changes.end());
  if (!changes.empty()) measures_->cycles().forget_means();
  state_.options = now;
  start_results(options);
}

// Judges the system as it is at the start, also of a restart.
template <int Dim>
void Simulation<Dim>::judge_start(const CaseOptions<Dim>& chosen) {
  begin_step(*system_, system_->state.positions, clock().time, 0);  // forces look at what is near
  const StatisticsOptions& statistics = chosen.measure.statistics;
  const PhaseStatistics* phases = measures_->phases();
  const bool samples = statistics.take || phases;
  at_start_ = start_findings(*system_, measures_->cycles(),
                             {.end = run_.time_end,
                              .checkpoint_interval = run_.checkpoint_interval,
                              .output_interval = run_.output_interval,
                              .history_interval = run_.history_interval,
                              .verify_interval = chosen.model.verify_interval,
                              .sampling_start = samples ? statistics.start : 0,
                              .sampling_interval = samples ? statistics.interval : 0,
                              .phase_period = phases && phases->count() > 1 ? phases->options().period : 0});
}

template <int Dim>
void Simulation<Dim>::refuse_doubts() const {
  if (!run_.strict) return;
  std::vector<std::string> doubts;
  const std::string start = "warning: ";
  for (const std::string& note : notes_)
    if (note.starts_with(start)) doubts.push_back(note.substr(start.size()));
  for (const Finding& finding : doubtful(at_start_)) doubts.push_back("of " + finding.name + ", " + finding.text);
  if (doubts.empty()) return;
  throw InputError("-strict: " + std::to_string(doubts.size()) + (doubts.size() == 1 ? " warning" : " warnings") +
                   ", the first " + doubts.front());
}

template <int Dim>
void Simulation<Dim>::start_results(Options& options) {
  make_writable_folder(options.comm(), run_.output_dir);
  if (run_.check && Results<Dim>::holds_a_run(options.comm(), run_.output_dir)) {
    run_.output_dir += "/check";  // a check must not spoil the results of a run
    make_writable_folder(options.comm(), run_.output_dir);
  }
  lock_ = std::make_unique<FolderLock>(options.comm(), run_.output_dir);
  if (rank_of(options.comm()) == 0) remove_parts(run_.output_dir);
  write_text_file(options.comm(), run_.output_dir + "/resolved.opts", repeatable(options.resolved()));
  const long continues_from = run_.restart.empty() || run_.check ? -1 : clock().step;
  if (continues_from < 0 && !run_.check) Results<Dim>::remove_ends(options.comm(), run_.output_dir);
  if (continues_from >= 0) Results<Dim>::remove_summary(options.comm(), run_.output_dir);
  results_ = std::make_unique<Results<Dim>>(*system_, *measures_, profiles_, run_.output_dir, continues_from);
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
  refuse_doubts();
  if (run_.check) return check_only();
  const StopSignals signals;
  try {
    bool stopped = false;
    progress_.begin(clock().step, clock().time);
    while (!finished() && !stopped) {
      step();
      stopped = signals.requested(system_->model.grid.comm());
    }
    save_checkpoint();
    end(stopped ? "stopped" : "finished");
  } catch (const DivergedError& error) {
    end("failed");
    throw DivergedError("diverged in step " + std::to_string(attempted_step_) + " after t = " +
                        format_text("%.6g", attempt_start_) + " s: " + error.what() + "; " + where_it_failed());
  }
}

template <int Dim>
void Simulation<Dim>::step() {
  if (clock().step > 0) steps_->adapt(state_, measures_->flow().courant.value);
  attempted_step_ = clock().step + 1;
  attempt_start_ = clock().time;
  if (steps_->may_shorten() || measures_all(attempted_step_, attempt_start_ + state_.dt)) measures_->prepare();
  steps_->advance(state_);
  const bool all = measures_all(clock().step, clock().time);
  check_markers();  // before anything is measured: crossings look at all space between a cloth's markers
  measures_->verify(state_.dt);
  measures_->observe(state_.dt, all);
  check_velocity();
  watch_rest();
  if (run_.time_cfl > 0) steps_->find_cloth_bound(state_);
  const double time = clock().time;
  if (all) results_->write_row(clock().step);
  if (due(run_.output_interval, time)) results_->write_frame(clock().step);
  if (due(run_.checkpoint_interval, time)) save_checkpoint();
  if (clock().step % 50 == 0) watch_step_bound();
  progress_.show({.step = clock().step,
                  .time = time,
                  .end = run_.time_end,
                  .courant = measures_->flow().courant.value,
                  .momentum_iterations = system_->model.fluid.counts().momentum / static_cast<double>(clock().step),
                  .pressure_iterations = system_->model.fluid.counts().pressure / static_cast<double>(clock().step)});
}

// Writes a checkpoint, once per step, so that the previous one is of an earlier step.
template <int Dim>
void Simulation<Dim>::save_checkpoint() {
  if (clock().step == kept_step_) return;
  kept_step_ = clock().step;
  write_checkpoint<Dim>(run_.output_dir, *system_, *measures_, state_);
}

// Whether a multiple of the interval lies in the step that ends at a time.
template <int Dim>
bool Simulation<Dim>::due(double interval, double time) const {
  const double now = time / interval, before = (time - state_.dt) / interval;
  return std::floor(now + 1e-6) > std::floor(before + 1e-6);
}

// Whether all is measured after the step that will end at a time, which may turn out to be the last one at rest.
template <int Dim>
bool Simulation<Dim>::measures_all(long step, double time) const {
  return run_.history_interval == 0 || due(run_.history_interval, time) || ends(step, time, state_.steps_at_rest + 1);
}

template <int Dim>
bool Simulation<Dim>::ends(long step, double time, int steps_at_rest) const {
  const bool enough_steps = run_.max_steps > 0 && step - first_step_ >= run_.max_steps;
  constexpr int steps_of_rest = 10;
  return enough_steps || steps_at_rest >= steps_of_rest || time >= run_.time_end - 1e-6 * state_.dt;
}

template <int Dim>
void Simulation<Dim>::watch_rest() {
  if (run_.rest_speed == 0) return;
  int& steps = state_.steps_at_rest;
  double fastest = 0;
  for (const auto& velocity : system_->state.velocities) fastest = std::max(fastest, velocity.norm());
  fastest *= 1 + system_->step.cloth_slip;  // so that the water round them rests too
  if (largest(system_->model.grid.comm(), fastest) >= run_.rest_speed)
    steps = 0;
  else if (steps != RunState::not_moved)
    ++steps;
}

template <int Dim>
void Simulation<Dim>::check_markers() const {
  const Points<Dim>& positions = system_->state.positions;
  if (system_->model.has_fluid) return system_->model.transfer.check_inside(positions);
  const bool finite =
      std::all_of(positions.begin(), positions.end(), [](const Point<Dim>& place) { return place.allFinite(); });
  if (any_rank(system_->model.grid.comm(), !finite)) throw DivergedError("cloth: a marker's place is not finite");
}

template <int Dim>
void Simulation<Dim>::check_velocity() const {
  const Located& worst = measures_->flow().courant;
  if (worst.value <= run_.max_courant) return;
  const std::string advice = run_.time_cfl == 0 ? " (-time_cfl 0.5 would shorten the steps in time)"
                                                : " (smaller -time_cfl, or a -time_step that none exceeds)";
  const std::string what = std::isfinite(worst.value)
                               ? format_text("velocity: CFL number %.3g exceeds -time_max_cfl %.3g%s", worst.value,
                                             run_.max_courant, advice.c_str())
                               : std::string("velocity: not finite");
  throw DivergedError(what);
}

template <int Dim>
std::string Simulation<Dim>::where_it_failed() const {
  const std::string contact = tightest_contact(system_->model.forces);
  const Located& worst = measures_->flow().courant;
  const std::string touches = contact.empty() ? "" : "the tightest contact: " + contact;
  if (!system_->model.has_fluid) return touches.empty() ? "nothing touches" : touches;
  return (touches.empty() ? "" : touches + "; ") + "the velocity was last seen largest at (" +
         list_text<Dim>(Point<Dim>(worst.place)) + ") m" + format_text(", CFL number %.3g", worst.value);
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
  for (const std::string& note : notes_) progress_.note(note);
  for (const std::string& line : banner_lines(system_->model, run_.case_name, coupling_)) progress_.note(line);
  const double bound = scheme_->step_bound(*system_);
  progress_.note(format_text("  time      step %.4g s, end %.4g s", state_.dt, run_.time_end) +
                 (std::isfinite(bound)                        ? format_text(", bound of the coupling %.4g s", bound)
                  : system_->model.cloths.marker_count() == 0 ? ""
                                                              : ", which the coupling does not bound"));
  for (const std::string& line : demonstration_lines(measures_->cycles(), run_.time_end)) progress_.note(line);
  for (const std::string& line : trust_lines(at_start_, run_.check)) progress_.note(line);
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
void Simulation<Dim>::end(const std::string& status) {
  progress_.finish();
  RunSummary summary;
  summary.case_name = run_.case_name;
  summary.status = status;
  summary.steps = clock().step;
  summary.time = clock().time;
  summary.wall_seconds = progress_.wall_seconds();
  summary.seconds_per_step = summary.wall_seconds / static_cast<double>(std::max(1L, clock().step - first_step_));
  if (status != "failed") {
    results_->write_frame(clock().step);
    results_->write_final();
  }
  summary.at_start = at_start_;
  summary.at_end = end_findings(*system_, *measures_, run_.time_cfl);
  results_->write_summary(summary);
  print_summary(summary);
}

template <int Dim>
void Simulation<Dim>::print_summary(const RunSummary& summary) {
  for (const std::string& line : result_lines(*system_, *measures_, summary)) progress_.note(line);
  for (const std::string& line : cycle_lines(measures_->cycles())) progress_.note(line);
  for (const std::string& line : trust_lines(summary.at_end, true)) progress_.note(line);
  progress_.note("  results            " + run_.output_dir);
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace washfsi
