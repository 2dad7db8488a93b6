// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/implicit_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/coupling/acceleration.hpp"
#include "washfsi/coupling/coupling_operations.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

template <int Dim>
ImplicitCoupling<Dim>::ImplicitCoupling(System<Dim>& system, const CouplingOptions& options)
    : options_(options),
      solver_(system.model.forces, system.state.positions,
              system.model.forces.have_step_limit() ? ClothSolverDefaults{SNESNEWTONLS, false, true}
                                                    : ClothSolverDefaults{SNESQN, false}),
      force_equation_(solver_),
      seepage_(system.model),
      mobility_(system.model) {
  if (!system.model.forces.have_step_limit()) return;
  check_symmetry(system.model);
  if (const MarkerForce<Dim>* force = without_jacobian(system.model.forces))
    throw InputError(force->origin() +
                     ": has no energy; use -coupling_scheme explicit or midpoint, or else -contact none");
}

template <int Dim>
double ImplicitCoupling<Dim>::step_bound(const System<Dim>&) const {
  return std::numeric_limits<double>::infinity();
}

// U^(n+1) of a whole fluid step with the cloth moved at these velocities; leaves the fluid before `finish`.
template <int Dim>
Points<Dim> ImplicitCoupling<Dim>::fluid_step(System<Dim>& system, double dt, const Points<Dim>& velocities) const {
  auto& [model, state, step] = system;
  step.evaluated_at = state.positions + dt * velocities;
  // in the middle of the motion the damping is exactly beta N' dE11/dt: a turning edge is not strained
  const Points<Dim> middle = state.positions + 0.5 * dt * velocities;
  model.locate_cloth(step.evaluated_at);
  spread_cloth(system, model.forces.of_places(step.evaluated_at) + model.forces.of_velocities(middle, velocities) +
                           model.forces.constant());
  model.fluid.projection().restore_pressure();
  move_water(system, dt);
  const Points<Dim> water = marker_velocities(model, model.fluid.intermediate_velocity(), state.clock.time + dt);
  return seepage_.present() ? water + seepage_.velocities(step.force_on_water) : water;
}

template <int Dim>
double ImplicitCoupling<Dim>::tolerance(const System<Dim>& system) const {
  const auto& [model, state, step] = system;
  double speed = 0;
  // in the first step, when all is at rest, the velocity after a first trial
  const Vec velocity = model.fluid.last_step() > 0 ? model.fluid.velocity() : model.fluid.intermediate_velocity();
  WASH_PETSC(VecNorm(velocity, NORM_INFINITY, &speed));
  speed = std::max(speed, model.boundary.largest_speed(state.clock.time));
  return options_.tolerance * speed * std::sqrt(static_cast<double>(model.cloths.marker_count()));
}

// Solves for W by Broyden's method; stores U^(n+1) in `last`.
template <int Dim>
Points<Dim> ImplicitCoupling<Dim>::solve(System<Dim>& system, double dt, Points<Dim>& last) {
  Model<Dim>& model = system.model;
  const State<Dim>& state = system.state;
  Points<Dim> evaluated;
  const auto residual = [&](const Points<Dim>& velocities) {
    evaluated = velocities;
    last = fluid_step(system, dt, velocities);
    const Points<Dim> result = velocities - weight() * last;
    return is_trapezoidal() ? result - 0.5 * state.velocities : result;
  };
  const auto assemble = [&](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    const petsc::LogPart part("cloth_solve");
    const std::vector<double> mobility =
        row_sum_mobility<Dim>(model.transfer, model.grid, model.boundary, model.liquid.density(),
                              model.bodies.fluid_fraction(), std::vector<double>(state.positions.size(), 1.0));
    model.forces.stiffness().set(state.positions + dt * velocities, geometric,
                                 weight() * dt * dt * options_.mobility_factor, matrix);
    scale_and_shift<Dim>(mobility, std::vector<double>(mobility.size(), 1.0), matrix);
  };
  Points<Dim> velocities = state.velocities;
  if (model.fluid.last_step() == 0) last = fluid_step(system, dt, velocities);
  system.step.cloth_iterations +=
      static_cast<double>(solver_.solve({residual, assemble, 0}, tolerance(system), velocities));
  if (any_rank(model.grid.comm(), evaluated != velocities)) last = fluid_step(system, dt, velocities);
  return velocities;
}

// Starts from W of the last step up to the step limit.
template <int Dim>
Points<Dim> ImplicitCoupling<Dim>::solve_by_sweeps(System<Dim>& system, double dt, Points<Dim>& last) {
  constexpr int most_sweeps = 200;
  auto& [model, state, step] = system;
  Points<Dim> velocities = model.forces.step_limit(state.positions, dt * state.velocities) * state.velocities;
  for (int n = 0; n < most_sweeps; ++n) {
    last = fluid_step(system, dt, velocities);
    Points<Dim> reached = weight() * last;
    if (is_trapezoidal()) reached += 0.5 * state.velocities;
    const double enough = tolerance(system);
    if (norm(model.grid.comm(), velocities - reached) <= enough) return velocities;
    mobility_.find(model, step.evaluated_at, weight() * options_.mobility_factor, true);
    seepage_.add_to(mobility_, weight() / dt);
    const Points<Dim> forces = model.forces.of_places(step.evaluated_at);
    velocities = force_equation_.solve({model.forces, dt, state.positions, reached, forces, mobility_, 0.1 * enough},
                                       {velocities, reached}, step.cloth_iterations);
  }
  throw DivergedError("cloth: its equations could not be solved in " + std::to_string(most_sweeps) +
                      " sweeps; a shorter step, or -coupling_mobility_factor above 1, may help");
}

template <int Dim>
void ImplicitCoupling<Dim>::advance_fields(System<Dim>& system, double dt) {
  Model<Dim>& model = system.model;
  State<Dim>& state = system.state;
  if (seepage_.present()) {
    begin_step(system, state.positions, state.clock.time, 0);
    seepage_.begin_step(state, model.forces.of_places(state.positions) + model.forces.constant(), dt);
  }
  begin_step(system, state.positions, state.clock.time + dt, dt,
             is_trapezoidal() ? trapezoidal_difference(system, dt) : backward_difference(system, dt));
  place_bodies(system, state.clock.time + dt);
  model.fluid.projection().save_pressure();
  Points<Dim> last;
  const Points<Dim> velocities =
      model.forces.have_step_limit() ? solve_by_sweeps(system, dt, last) : solve(system, dt, last);
  if (seepage_.present()) system.step.seepage_power = seepage_.power(system.step.force_on_water);
  seepage_.finish_step(system.step.force_on_water, state);
  model.water_step().finish();
  state.positions += dt * velocities;
  state.velocities = last;
}

template class ImplicitCoupling<2>;
template class ImplicitCoupling<3>;

}  // namespace washfsi
