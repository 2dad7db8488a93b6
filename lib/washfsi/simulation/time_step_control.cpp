// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/time_step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/coupling/step_error.hpp"
#include "washfsi/coupling/system_state.hpp"
#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

template <int Dim>
TimeStepControl<Dim>::TimeStepControl(const RunOptions& run, const CouplingOptions& coupling, System<Dim>& system,
                                      CouplingScheme<Dim>& scheme)
    : run_(run), system_(system), scheme_(scheme), body_speeds_(system.model) {
  if (run.time_tolerance == 0) return;
  if (system.model.has_fluid && coupling.scheme == "implicit" && coupling.time_scheme == TimeScheme::trapezoidal)
    throw InputError("-time_tolerance " + to_text(run.time_tolerance) + ": not with -" + coupling.scheme_option +
                     " implicit, whose steps are those that it compares with; use semi_implicit");
}

// Whether bodies in direct forcing meet moving water at the start, or start moving abruptly in water at rest.
template <int Dim>
bool TimeStepControl<Dim>::starts_at_once() const {
  double speed = 0;
  WASH_PETSC(VecNorm(system_.model.fluid.velocity(), NORM_INFINITY, &speed));
  const bool moves_off = std::ranges::any_of(system_.model.body_list, [&](const auto& body) {
    const auto motion = body.motion.state(system_.state.clock.time);
    return motion.angular_velocity != 0 || !motion.velocity.isZero(0);
  });
  return system_.model.bodies.wall_forces() && (speed > 0 || moves_off);
}

template <int Dim>
void TimeStepControl<Dim>::begin(RunState& state) const {
  if (run_.time_step > 0 && run_.time_cfl == 0) state.dt = run_.time_step;
  refuse_unseen_motion<Dim>(system_.model.body_list, run_.time_step);
  if (state.cloth_bound == 0) find_cloth_bound(state);
  if (state.dt > 0) return;  // the user's, or that of the checkpoint
  // walls that meet water abruptly double its speed beside them, and at edges it grows as the grid gets finer
  const double courant = (run_.time_cfl > 0 ? run_.time_cfl : 0.3) * (starts_at_once() ? 0.125 : 1);
  state.dt = std::min(longest_step(state), courant * flow_time<Dim>(system_.model, body_speeds_));
  if (!std::isfinite(state.dt))
    throw InputError("-time_step is missing: nothing moves at the start from which it could be chosen");
  state.dt = tried(state.dt);
}

namespace {

constexpr int most_trials = 12;

// Shortens a step whose CFL number was `found` instead of `courant`.
double shortened(double dt, double courant, double found) {
  constexpr double aim = 0.9, least = 0.1;
  return dt * std::max(least, aim * courant / found);
}

}  // namespace

// Tries shorter and shorter steps; if none is short enough, returns the given one: the run then fails with the reason.
// Steps of constant length may have a larger CFL number, since the flow slows down after its start.
template <int Dim>
double TimeStepControl<Dim>::tried(double dt) const {
  if (!system_.model.has_fluid) return dt;
  const double courant = run_.time_cfl > 0 ? run_.time_cfl : 0.6 * std::min(1.0, run_.max_courant);
  const SavedStart<Dim> start(system_);
  double trial = dt;
  for (int n = 0; n < most_trials; ++n) {
    const double found = courant_after(trial).value_or(std::numeric_limits<double>::infinity());
    start.restore();
    if (found <= courant * (1 + 1e-6)) return trial;
    trial = shortened(trial, courant, found);
  }
  return dt;
}

template <int Dim>
bool TimeStepControl<Dim>::may_shorten() const {
  constexpr long first_steps = 20;
  return run_.time_cfl > 0 && system_.model.has_fluid && system_.state.clock.step < first_steps;
}

// The length is chosen from the flow before the step, so the CFL number may exceed the aim by a quarter; otherwise the
// step is repeated, shorter. The last trial is accepted in any case.
template <int Dim>
void TimeStepControl<Dim>::advance(RunState& state) const {
  constexpr double more = 1.25, below_most = 0.95;
  if (may_shorten()) {
    const double most = std::min(more * run_.time_cfl, below_most * run_.max_courant);
    const SavedStart<Dim> start(system_);
    for (int n = 1; n < most_trials; ++n) {
      const std::optional<double> found = courant_after(state.dt);
      if (found && *found <= most) return;
      start.restore();
      state.dt = shortened(state.dt, run_.time_cfl, found.value_or(2 * run_.time_cfl));
    }
  }
  scheme_.advance(system_, state.dt);
}

// CFL number after a step: infinite if the flow is not finite; none if the step fails.
template <int Dim>
std::optional<double> TimeStepControl<Dim>::courant_after(double dt) const {
  try {
    scheme_.advance(system_, dt);
  } catch (const DivergedError&) {
    return {};
  }
  return courant_now(dt);
}

template <int Dim>
double TimeStepControl<Dim>::courant_now(double dt) const {
  const Model<Dim>& model = system_.model;
  const GhostedVelocity<Dim> local(model.boundary, model.grid.face_dm(), model.fluid.velocity(),
                                   system_.state.clock.time);
  return FlowDiagnostics<Dim>::of(model.grid, {local, model.liquid.fields(), model.bodies.fluid_share()}, dt)
      .courant.value;
}

template <int Dim>
void TimeStepControl<Dim>::find_cloth_bound(RunState& state) const {
  if (run_.time_step == 0) state.cloth_bound = scheme_.step_bound(system_);
}

// The user's step, or that which the cloth allows; at most that which resolves each start, stop and reversal of bodies.
template <int Dim>
double TimeStepControl<Dim>::longest_step(const RunState& state) const {
  return std::min(run_.time_step > 0 ? run_.time_step : 0.5 * state.cloth_bound,
                  longest_step_of_motion<Dim>(system_.model.body_list));
}

// -time_tolerance: the step for which the error of the cloths' velocities is this share of the largest speed,
// prescribed or present; without water that of the cloths.
template <int Dim>
double TimeStepControl<Dim>::accurate_step(const RunState& state) const {
  const double error = run_.time_tolerance > 0 ? step_error(system_) : 0;
  if (error == 0) return std::numeric_limits<double>::infinity();
  double speed = system_.model.grid.spacing().minCoeff() / flow_time(system_.model, body_speeds_);
  for (const Point<Dim>& velocity : system_.state.velocities) speed = std::max(speed, velocity.cwiseAbs().maxCoeff());
  return state.dt * run_.time_tolerance * largest(system_.model.grid.comm(), speed) / error;
}

// -time_cfl: the step for the present flow, growing slowly, and for bodies that are about to start. Accuracy shortens
// it at most to a fixed share, since the errors of jumps do not fall with the step.
template <int Dim>
void TimeStepControl<Dim>::adapt(RunState& state, double courant) const {
  if (run_.time_cfl == 0) return;
  constexpr double most_growth = 1.05, least_part = 1.0 / 16;
  const double for_flow = std::min(longest_step(state), state.dt * run_.time_cfl / courant);  // infinite at rest
  state.dt = std::min(most_growth * state.dt, std::clamp(accurate_step(state), least_part * for_flow, for_flow));
  state.dt = body_speeds_.longest_step(system_.state.clock.time, state.dt, run_.time_cfl);
}

template class TimeStepControl<2>;
template class TimeStepControl<3>;

}  // namespace washfsi
