// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/semi_implicit_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "washfsi/coupling/acceleration.hpp"
#include "washfsi/coupling/coupling_operations.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/point_vectors.hpp"

namespace washfsi {

namespace {

constexpr double least_share = 0.75;  // least share of the mobility with which any step of order 1 is stable

// Whether more than three markers would lie within a kernel if all were spread evenly over the box. Then the pressure,
// which the mobility neglects, resists much of the motion that the mobility allows.
template <int Dim>
bool is_packed(const Model<Dim>& model) {
  constexpr double many = 3;
  double cells_per_marker = 1 / static_cast<double>(std::max<PetscInt>(model.cloths.marker_count(), 1)), reached = 1;
  for (int d = 0; d < Dim; ++d) {
    cells_per_marker *= static_cast<double>(model.grid.cells()[d]);
    reached *= 2 * model.transfer.delta().spread_width;
  }
  return Dim == 3 && model.forces.have_step_limit() && reached > many * cells_per_marker;
}

// F_inertia^n, the force of inertia of the last step, from the velocities at its ends.
template <int Dim>
Points<Dim> last_inertia(const System<Dim>& system) {
  const State<Dim>& state = system.state;
  Points<Dim> inertia(state.positions.size(), Point<Dim>::Zero());
  const double dt_before = system.model.fluid.last_step();
  if (dt_before == 0 || system.model.cloth_treatment.mass_carrier == MassCarrier::water) return inertia;
  for (std::size_t m = 0; m < inertia.size(); ++m)
    inertia[m] =
        -system.model.cloths.marker_masses()[m] / dt_before * (state.velocities[m] - state.velocities_before[m]);
  return inertia;
}

}  // namespace

template <int Dim>
SemiImplicitCoupling<Dim>::SemiImplicitCoupling(System<Dim>& system, const CouplingOptions& options)
    : options_(options),
      solver_(system.model.forces, system.state.positions,
              {SNESNEWTONLS, options.mobility == Mobility::row_sums, options.mobility == Mobility::matrix}),
      force_equation_(solver_),
      mobility_(system.model),
      seepage_(system.model) {
  if (const MarkerForce<Dim>* force = without_jacobian(system.model.forces))
    throw InputError(force->origin() + ": has no Jacobian; use -coupling_scheme explicit or midpoint");
  if (options.mobility == Mobility::matrix) check_symmetry(system.model);
}

template <int Dim>
double SemiImplicitCoupling<Dim>::step_bound(const System<Dim>&) const {
  return std::numeric_limits<double>::infinity();
}

template <int Dim>
void SemiImplicitCoupling<Dim>::set_weights(const System<Dim>& system, double dt) {
  const double dt_before = system.model.fluid.last_step();
  weights_ = {};
  if (options_.order == 1 || dt_before == 0) return;
  const double sixteenths = dt / dt_before / 16;
  weights_ = {9.0 / 16, 7.0 / 16 - sixteenths, sixteenths};
}

template <int Dim>
void SemiImplicitCoupling<Dim>::find_explicit_velocity(const System<Dim>& system) {
  if (weights_.end == 1) return;
  const FractionalStep<Dim>& fluid = system.model.fluid;
  if (!explicit_velocity_) explicit_velocity_ = system.model.grid.face_vector();
  WASH_PETSC(
      VecAXPBYPCZ(explicit_velocity_, weights_.start, weights_.before, 0, fluid.velocity(), fluid.velocity_before()));
}

template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::water_velocities(const System<Dim>& system, double dt) const {
  const auto& [model, state, step] = system;
  const FractionalStep<Dim>& fluid = model.fluid;
  if (weights_.end == 1) return marker_velocities(model, fluid.intermediate_velocity(), state.clock.time + dt);
  const petsc::GlobalVector mean(model.grid.face_dm());
  WASH_PETSC(VecWAXPY(mean, weights_.end, fluid.intermediate_velocity(), explicit_velocity_));
  return marker_velocities(model, mean, state.clock.time + 0.5 * dt);
}

template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::reached_velocities(const System<Dim>& system, double dt) const {
  const Points<Dim> water = water_velocities(system, dt);
  return seepage_.present() ? water + seepage_.velocities(system.step.force_on_water) : water;
}

template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::solve_velocities(System<Dim>& system, double dt,
                                                        const Points<Dim>& free_velocities, const Points<Dim>& forces) {
  const petsc::LogPart part("cloth_solve");
  const MPI_Comm comm = system.model.grid.comm();
  const double tolerance = options_.tolerance * std::hypot(norm(comm, free_velocities), norm(comm, velocities_));
  if (options_.mobility == Mobility::row_sums) return solve_by_row_sums(system, dt, free_velocities, forces, tolerance);
  return system.model.forces.have_step_limit() ? solve_by_forces(system, dt, free_velocities, forces, tolerance)
                                               : solve_by_matrix(system, dt, free_velocities, forces, tolerance);
}

template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::solve_by_forces(System<Dim>& system, double dt,
                                                       const Points<Dim>& free_velocities, const Points<Dim>& forces,
                                                       double tolerance) {
  const typename ForceEquation<Dim>::Step step{
      system.model.forces, dt, system.state.positions, free_velocities, forces, mobility_, tolerance};
  std::vector<Points<Dim>> guesses{velocities_, free_velocities};
  if (!change_.empty()) guesses.push_back(force_equation_.velocities(step, 1, change_));
  change_.clear();
  return force_equation_.solve(step, guesses, system.step.cloth_iterations);
}

// W - U - dt M [F(X^n + dt W) - F] = 0
template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::solve_by_matrix(System<Dim>& system, double dt,
                                                       const Points<Dim>& free_velocities, const Points<Dim>& forces,
                                                       double tolerance) {
  const Forces<Dim>& all = system.model.forces;
  const Points<Dim>& start = system.state.positions;
  const auto residual = [&](const Points<Dim>& velocities) {
    const Points<Dim> gained = mobility_.times(all.of_places(start + dt * velocities) - forces);
    return velocities - free_velocities - dt * gained;
  };
  Points<Dim> linearised_at;
  const auto assemble = [&](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    linearised_at = start + dt * velocities;
    all.stiffness().set(linearised_at, geometric, 1, matrix);
    mobility_.precondition(dt * dt, matrix);
  };
  const auto jacobian = [&](const Points<Dim>& direction) {
    return direction + dt * dt * mobility_.times(all.stiffness().product(linearised_at, direction));
  };
  double most = 0;
  for (const double sum : mobility_.row_sums()) most = std::max(most, sum);
  const double round_off = 10 * dt * largest(system.model.grid.comm(), most) * all.round_off(start);
  Points<Dim> velocities = velocities_;
  system.step.cloth_iterations +=
      static_cast<double>(solver_.solve({residual, assemble, round_off, {}, jacobian}, tolerance, velocities));
  return velocities;
}

// D^-1 (W - U) - dt [F(X^n + dt W) - F] = 0, the gradient of a potential
template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::solve_by_row_sums(System<Dim>& system, double dt,
                                                         const Points<Dim>& free_velocities, const Points<Dim>& forces,
                                                         double tolerance) {
  Forces<Dim>& all = system.model.forces;
  const Points<Dim>& start = system.state.positions;
  const auto residual = [&](const Points<Dim>& velocities) {
    const Points<Dim> forces_at_end = all.of_places(start + dt * velocities);
    Points<Dim> result(velocities.size());
    for (std::size_t m = 0; m < result.size(); ++m)
      result[m] = (velocities[m] - free_velocities[m]) / mobility_.row_sums()[m] - dt * (forces_at_end[m] - forces[m]);
    return result;
  };
  std::vector<double> inverse;
  for (const double sum : mobility_.row_sums()) inverse.push_back(1 / sum);
  const auto assemble = [&](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    all.stiffness().set(start + dt * velocities, geometric, dt * dt, matrix);
    scale_and_shift<Dim>(std::vector<double>(inverse.size(), 1.0), inverse, matrix);
  };
  const auto potential = [&](const Points<Dim>& velocities) {
    double work = 0;
    for (std::size_t m = 0; m < velocities.size(); ++m)
      work += 0.5 * inverse[m] * (velocities[m] - free_velocities[m]).squaredNorm() + dt * forces[m].dot(velocities[m]);
    const std::vector<double> energies = all.energies(start + dt * velocities);
    return std::accumulate(energies.begin(), energies.end(), ordered_sum(system.model.grid.comm(), work));
  };
  double squares = 0;
  for (const double value : inverse) squares += value * value;
  const double markers = static_cast<double>(system.model.cloths.marker_count());
  const double weight = std::sqrt(ordered_sum(system.model.grid.comm(), squares) / markers);
  ClothEquation<Dim> equation{residual, assemble, 10 * dt * all.round_off(start), potential};
  Points<Dim> velocities = velocities_;
  if (all.have_step_limit()) {
    velocities = all.step_limit(start, dt * velocities_) * velocities_;
    equation.step_limit = [&](const Points<Dim>& from, const Points<Dim>& way) {
      return all.step_limit(start + dt * from, dt * way);
    };
  }
  solve_sharply(all, [&] {
    system.step.cloth_iterations += static_cast<double>(solver_.solve(equation, weight * tolerance, velocities));
    return start + dt * velocities;
  });
  return velocities;
}

template <int Dim>
double SemiImplicitCoupling<Dim>::slip(MPI_Comm comm, const Points<Dim>& interpolated) const {
  const double speed = norm(comm, velocities_);
  return speed > 0 ? norm(comm, velocities_ - interpolated) / speed : 0;
}

// Items 5 to 7: advances from the forces at the start to those at the end, with the water's velocity at the markers.
template <int Dim>
void SemiImplicitCoupling<Dim>::iterate(System<Dim>& system, double dt, Points<Dim> forces, Points<Dim> interpolated) {
  auto& [model, state, step] = system;
  const petsc::GlobalVector increment(model.grid.face_dm());
  for (PetscInt n = 0; n < options_.sweeps; ++n) {
    velocities_ = solve_velocities(system, dt, interpolated, forces);
    step.evaluated_at = state.positions + dt * velocities_;
    const Points<Dim> forces_at_end = model.forces.of_places(step.evaluated_at);
    const Points<Dim> gained = weights_.end * (forces_at_end - forces);
    WASH_PETSC(VecZeroEntries(increment));
    step.side_reaction += model.transfer.spread_with_reaction(gained, increment);
    step.force_on_water += gained;
    model.water_step().add_force(increment);
    model.water_step().enforce_no_slip();
    WASH_PETSC(VecAXPY(step.force, 1.0, increment));
    forces = forces_at_end;
    interpolated = reached_velocities(system, dt);
    step.cloth_slip = slip(model.grid.comm(), interpolated);
    if (step.cloth_slip <= options_.slip_tolerance) break;
    if (is_packed(model) && options_.mobility_factor >= 1) mobility_.set_share(least_share);
  }
}

// The forces at the end enter the mean force with the weight w_0. Inertia and friction act over the whole step, so they
// are divided by it.
template <int Dim>
void SemiImplicitCoupling<Dim>::prepare_end_forces(System<Dim>& system, double dt) const {
  begin_step(system, system.state.positions, system.state.clock.time + dt, dt,
             options_.order == 1 ? backward_difference(system, dt) : centred_difference(system, dt), weights_.end);
}

template <int Dim>
void SemiImplicitCoupling<Dim>::advance_fields(System<Dim>& system, double dt) {
  auto& [model, state, step] = system;
  const double start = state.clock.time, end = start + dt;
  set_weights(system, dt);
  find_explicit_velocity(system);
  begin_step(system, state.positions, start, 0);
  const Points<Dim> at_start = model.forces.of_places(state.positions);
  step.end_share = weights_.end;
  if (step.end_share < 1)
    step.contact_at_start = contact_loads<Dim>(model.forces, state.positions, model.body_list.size());
  const Points<Dim> forces = at_start + (1 / weights_.end) * last_inertia(system);
  prepare_end_forces(system, dt);
  const Points<Dim> places = state.positions + 0.5 * dt * state.velocities;
  model.locate_cloth(places);
  spread_cloth(system, weights_.end * forces + weights_.start * at_start + weights_.before * state.forces_before +
                           model.forces.constant());
  place_bodies(system, end);
  predict_water(system, dt);
  model.water_step().project();

  velocities_ = state.velocities;
  change_ = at_start - (state.clock.step > 0 ? state.forces_before : at_start);  // as in the last step
  mobility_.find(model, places, options_.mobility_factor * weights_.end * weights_.end,
                 options_.mobility == Mobility::matrix);
  seepage_.begin_step(state, step.force_on_water, dt);
  seepage_.add_to(mobility_, weights_.end / dt);
  iterate(system, dt, forces, reached_velocities(system, dt));
  if (seepage_.present()) step.seepage_power = seepage_.power(step.force_on_water);
  seepage_.finish_step(step.force_on_water, state);
  state.velocities = options_.order == 1 ? velocities_ : extrapolated(system, dt, velocities_);
  state.forces_before = at_start;
  model.water_step().finish();
  state.positions += dt * velocities_;
}

template class SemiImplicitCoupling<2>;
template class SemiImplicitCoupling<3>;

}  // namespace washfsi
