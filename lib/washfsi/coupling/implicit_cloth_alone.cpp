// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/implicit_cloth_alone.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "washfsi/coupling/coupling_operations.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

template <int Dim>
ImplicitClothAlone<Dim>::ImplicitClothAlone(System<Dim>& system, const CouplingOptions& options)
    : options_(options), solver_(system.model.forces, system.state.positions, {SNESNEWTONLS, true, true}) {
  if (const MarkerForce<Dim>* force = without_jacobian(system.model.forces))
    throw InputError(force->origin() + ": has no Jacobian; use -coupling_scheme explicit");
}

template <int Dim>
double ImplicitClothAlone<Dim>::step_bound(const System<Dim>&) const {
  return std::numeric_limits<double>::infinity();
}

template <int Dim>
ClothEquation<Dim> ImplicitClothAlone<Dim>::equation(System<Dim>& system, double dt) {
  Forces<Dim>& all = system.model.forces;
  const Points<Dim>&start = system.state.positions, &before = system.state.velocities;
  const Points<Dim> constant = all.constant();
  std::vector<double> mass_rates, drags;
  for (std::size_t m = 0; m < start.size(); ++m) {
    mass_rates.push_back(system.model.cloths.marker_masses()[m] / dt);
    drags.push_back(system.model.cloth_treatment.drag * system.model.cloths.marker_areas()[m]);
  }
  ClothEquation<Dim> equation;
  equation.residual = [=, &all, &start, &before](const Points<Dim>& velocities) {
    Points<Dim> result = -1.0 * (all.of_places(start + dt * velocities) + constant);
    for (std::size_t m = 0; m < result.size(); ++m)
      result[m] += mass_rates[m] * (velocities[m] - before[m]) + drags[m] * velocities[m];
    return result;
  };
  equation.assemble = [=, this, &all, &start](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    std::vector<double> diagonal = mass_rates;
    for (std::size_t m = 0; m < diagonal.size(); ++m) diagonal[m] += drags[m];
    all.stiffness().set(start + dt * velocities, geometric, dt, matrix);
    scale_and_shift<Dim>(std::vector<double>(diagonal.size(), 1.0), diagonal, matrix);
    jacobian_ = matrix;
  };
  equation.product = [this](const Points<Dim>& direction) { return product_(jacobian_, direction); };
  equation.round_off = 10 * all.round_off(start);
  equation.potential = [=, &all, &start, &before](const Points<Dim>& velocities) {
    double sum = 0;
    for (std::size_t m = 0; m < velocities.size(); ++m)
      sum += 0.5 * mass_rates[m] * (velocities[m] - before[m]).squaredNorm() +
             0.5 * drags[m] * velocities[m].squaredNorm() - constant[m].dot(velocities[m]);
    const std::vector<double> energies = all.energies(start + dt * velocities);
    return ordered_sum(all.comm(), sum) + std::accumulate(energies.begin(), energies.end(), 0.0) / dt;
  };
  if (all.have_step_limit())
    equation.step_limit = [=, &all, &start](const Points<Dim>& from, const Points<Dim>& way) {
      return all.step_limit(start + dt * from, dt * way);
    };
  return equation;
}

// A share of the forces that would stop the markers within dt, and of weight and loads.
template <int Dim>
double ImplicitClothAlone<Dim>::tolerance(const System<Dim>& system, double dt) const {
  const MPI_Comm comm = system.model.grid.comm();
  Points<Dim> momentum = system.state.velocities;
  for (std::size_t m = 0; m < momentum.size(); ++m) momentum[m] *= system.model.cloths.marker_masses()[m] / dt;
  return options_.tolerance * std::hypot(norm(comm, momentum), norm(comm, system.model.forces.constant()));
}

// The velocities of the last step up to the step limit, or the part of them with the least potential: Newton's method
// needs many steps to leave the barrier where facets have been brought too near, and few from farther away.
template <int Dim>
Points<Dim> ImplicitClothAlone<Dim>::guess(System<Dim>& system, double dt, const ClothEquation<Dim>& equation) const {
  const State<Dim>& state = system.state;
  const double free = system.model.forces.step_limit(state.positions, dt * state.velocities);
  Points<Dim> best = free * state.velocities;
  if (!system.model.forces.have_step_limit()) return best;
  double least = equation.potential(best);
  for (const double part : {0.75, 0.5, 0.25, 0.0}) {
    Points<Dim> other = part * free * state.velocities;
    const double potential = equation.potential(other);
    if (potential >= least) continue;
    least = potential;
    best = std::move(other);
  }
  return best;
}

// A step whose equations cannot be solved is taken in two halves, and these again.
template <int Dim>
void ImplicitClothAlone<Dim>::advance_fields(System<Dim>& system, double dt) {
  take_part(system, system.state.clock.time, dt, 0);
}

template <int Dim>
void ImplicitClothAlone<Dim>::take_part(System<Dim>& system, double start, double dt, int halvings) {
  constexpr int most_halvings = 6;
  try {
    solve(system, start, dt);
  } catch (const DivergedError&) {
    if (halvings == most_halvings) throw;
    take_part(system, start, 0.5 * dt, halvings + 1);
    take_part(system, start + 0.5 * dt, 0.5 * dt, halvings + 1);
  }
}

template <int Dim>
void ImplicitClothAlone<Dim>::solve(System<Dim>& system, double start, double dt) {
  auto& [model, state, step] = system;
  begin_step(system, state.positions, start + dt, dt);
  const ClothEquation<Dim> equation = this->equation(system, dt);
  Points<Dim> velocities = guess(system, dt, equation);
  solve_sharply(model.forces, [&, &record = step, &from = state.positions] {
    record.cloth_iterations += static_cast<double>(solver_.solve(equation, tolerance(system, dt), velocities));
    return record.evaluated_at = from + dt * velocities;
  });
  state.positions = step.evaluated_at;
  state.velocities = velocities;
}

template class ImplicitClothAlone<2>;
template class ImplicitClothAlone<3>;

}  // namespace washfsi
