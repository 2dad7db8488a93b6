// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/implicit_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/simulation/coupling_operations.hpp"
#include "washfsi/simulation/marker_vectors.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
ImplicitCoupling<Dim>::ImplicitCoupling(const System<Dim>& system, const CouplingOptions& options)
    : options_(options), solver_(system.cloths, system.positions, {SNESQN, false}) {}

template <int Dim>
double ImplicitCoupling<Dim>::step_bound(const System<Dim>&) const {
  return std::numeric_limits<double>::infinity();
}

// U^(n+1) of a whole fluid step with the cloth moved at these velocities; leaves the fluid before `finish`.
template <int Dim>
Points<Dim> ImplicitCoupling<Dim>::fluid_step(System<Dim>& system, double dt, const Points<Dim>& velocities) const {
  const double next = system.fluid.time() + dt;
  const Points<Dim> moved = sum<Dim>(system.positions, dt, velocities);
  // at half the way the damping is just beta Ke dE11/dt: a turning edge is not strained
  const Points<Dim> middle = sum<Dim>(system.positions, 0.5 * dt, velocities);
  Points<Dim> forces = system.cloths.elastic_forces(moved);
  forces = sum<Dim>(forces, 1, system.cloths.damping_forces(middle, velocities));
  spread_cloth(system, moved, sum<Dim>(forces, 1, external_forces(system, moved, next)));
  system.fluid.restore_pressure();
  predict_and_project(system, dt);
  return marker_velocities<Dim>(system, system.fluid.next_velocity(), next);
}

template <int Dim>
double ImplicitCoupling<Dim>::tolerance(const System<Dim>& system) const {
  double speed = 0;
  // at the start, when all is at rest, that after a first trial
  const Vec velocity = system.fluid.last_step() > 0 ? system.fluid.velocity() : system.fluid.next_velocity();
  WASH_PETSC(VecNorm(velocity, NORM_INFINITY, &speed));
  speed = std::max(speed, system.boundary.largest_speed(system.fluid.time()));
  return options_.tolerance * speed * std::sqrt(static_cast<double>(system.cloths.marker_count()));
}

template <int Dim>
void ImplicitCoupling<Dim>::advance(System<Dim>& system, double dt) {
  const bool trapezoidal = options_.time_scheme == "trapezoidal";
  const double weight = trapezoidal ? 0.5 : 1.0;
  hold_bodies(system, system.fluid.time() + dt);
  system.fluid.keep_pressure();
  Points<Dim> last, evaluated;
  const auto residual = [&](const Points<Dim>& velocities) {
    evaluated = velocities;
    last = fluid_step(system, dt, velocities);
    Points<Dim> result = sum<Dim>(velocities, -weight, last);
    return trapezoidal ? sum<Dim>(result, -0.5, system.velocities) : result;
  };
  const auto assemble = [&](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    const petsc::LogPart part("cloth_solve");
    const Vec share = system.mask.empty() ? nullptr : system.mask.fluid_fraction();
    const std::vector<double> mobility =
        row_sum_mobility<Dim>(system.transfer, system.grid, system.boundary, system.density, share,
                              std::vector<double>(system.positions.size(), 1.0));
    system.cloths.set_stiffness(sum<Dim>(system.positions, dt, velocities), geometric,
                                weight * dt * dt * options_.mobility_factor, matrix);
    scale_and_shift<Dim>(mobility, std::vector<double>(mobility.size(), 1.0), matrix);
  };
  Points<Dim> velocities = system.velocities;
  if (system.fluid.last_step() == 0) last = fluid_step(system, dt, velocities);
  system.cloth_iterations += static_cast<double>(solver_.solve({residual, assemble, 0}, tolerance(system), velocities));
  if (any_rank(system.grid.comm(), evaluated != velocities)) last = fluid_step(system, dt, velocities);
  system.fluid.finish();
  system.positions = sum<Dim>(system.positions, dt, velocities);
  system.velocities = last;
}

template class ImplicitCoupling<2>;
template class ImplicitCoupling<3>;

}  // namespace washfsi
