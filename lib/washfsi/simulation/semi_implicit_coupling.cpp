// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/semi_implicit_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "washfsi/simulation/coupling_operations.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
SemiImplicitCoupling<Dim>::SemiImplicitCoupling(const System<Dim>& system, const CouplingOptions& options)
    : options_(options), solver_(system.cloths, system.positions, {SNESNEWTONLS, true}) {}

template <int Dim>
double SemiImplicitCoupling<Dim>::step_bound(const System<Dim>&) const {
  return std::numeric_limits<double>::infinity();
}

// 1/D of each marker [kg; kg/m in the plane]. Within solids, where nothing moves a marker, D has a floor.
template <int Dim>
std::vector<double> SemiImplicitCoupling<Dim>::inverse_mobility(const System<Dim>& system) const {
  constexpr double floor = 1e-3;
  const Vec share = system.mask.empty() ? nullptr : system.mask.fluid_fraction();
  std::vector<double> result = row_sum_mobility<Dim>(system.transfer, system.grid, system.boundary, system.density,
                                                     share, std::vector<double>(system.positions.size(), 1.0));
  double most = 0;
  for (const double mobility : result) most = std::max(most, mobility);
  most = largest(system.grid.comm(), most);
  for (double& mobility : result) mobility = 1 / (options_.mobility_factor * std::max(mobility, floor * most));
  return result;
}

template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::move_elastically(System<Dim>& system, double dt,
                                                        const Points<Dim>& free_velocities, const Points<Dim>& forces,
                                                        const std::vector<double>& inverse_mobility) {
  const petsc::LogPart part("cloth_solve");
  const Cloths<Dim>& cloths = system.cloths;
  const auto residual = [&](const Points<Dim>& velocities) {
    const Points<Dim> moved = cloths.elastic_forces(sum<Dim>(system.positions, dt, velocities));
    Points<Dim> result(velocities.size());
    for (std::size_t m = 0; m < result.size(); ++m)
      result[m] = inverse_mobility[m] * (velocities[m] - free_velocities[m]) - dt * (moved[m] - forces[m]);
    return result;
  };
  const auto assemble = [&](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    cloths.add_stiffness(sum<Dim>(system.positions, dt, velocities), geometric, dt * dt, matrix);
    scale_and_shift<Dim>(std::vector<double>(inverse_mobility.size(), 1.0), inverse_mobility, matrix);
  };
  const auto potential = [&](const Points<Dim>& velocities) {
    double work = 0;
    for (std::size_t m = 0; m < velocities.size(); ++m)
      work += 0.5 * inverse_mobility[m] * (velocities[m] - free_velocities[m]).squaredNorm() +
              dt * forces[m].dot(velocities[m]);
    const std::vector<double> energies = cloths.elastic_energies(sum<Dim>(system.positions, dt, velocities));
    return std::accumulate(energies.begin(), energies.end(), ordered_sum(system.grid.comm(), work));
  };
  std::vector<double> squares{0, 0, 0};
  for (std::size_t m = 0; m < inverse_mobility.size(); ++m) {
    squares[0] += free_velocities[m].squaredNorm() + velocities_[m].squaredNorm();
    squares[1] += inverse_mobility[m] * inverse_mobility[m];
    squares[2] += 1;
  }
  squares = ordered_sum(system.grid.comm(), squares);
  const double speed = std::sqrt(squares[0] / squares[2]), weight = std::sqrt(squares[1]);
  Points<Dim> velocities = velocities_;
  const double tolerance = options_.tolerance * speed * weight;
  system.cloth_iterations += static_cast<double>(solver_.solve(residual, assemble, potential, tolerance, velocities));
  return velocities;
}

template <int Dim>
double SemiImplicitCoupling<Dim>::slip(const System<Dim>& system, const Points<Dim>& interpolated) const {
  std::vector<double> squares{0, 0};
  for (std::size_t m = 0; m < velocities_.size(); ++m) {
    squares[0] += (velocities_[m] - interpolated[m]).squaredNorm();
    squares[1] += velocities_[m].squaredNorm();
  }
  squares = ordered_sum(system.grid.comm(), squares);
  return squares[1] > 0 ? std::sqrt(squares[0] / squares[1]) : 0;
}

template <int Dim>
void SemiImplicitCoupling<Dim>::advance(System<Dim>& system, double dt) {
  const double time = system.fluid.time();
  Points<Dim> forces = system.cloths.elastic_forces(system.positions);
  spread_cloth(system, sum<Dim>(system.positions, 0.5 * dt, system.velocities),
               sum<Dim>(forces, 1, external_forces(system, system.positions, time)));
  hold_bodies(system, time + dt);
  predict_and_project(system, dt);

  velocities_ = system.velocities;
  const std::vector<double> inverse = inverse_mobility(system);
  Points<Dim> interpolated = marker_velocities<Dim>(system, system.fluid.next_velocity(), time + dt);
  const petsc::Vector increment = petsc::zeros_like(system.force);
  for (PetscInt sweep = 0; sweep < options_.sweeps; ++sweep) {
    velocities_ = move_elastically(system, dt, interpolated, forces, inverse);
    const Points<Dim> moved = system.cloths.elastic_forces(sum<Dim>(system.positions, dt, velocities_));
    WASH_PETSC(VecZeroEntries(increment));
    system.wall_reaction += system.transfer.spread(sum<Dim>(moved, -1, forces), increment);
    system.fluid.add_force(increment);
    WASH_PETSC(VecAXPY(system.force, 1.0, increment));
    forces = moved;
    interpolated = marker_velocities<Dim>(system, system.fluid.next_velocity(), time + dt);
    system.cloth_slip = slip(system, interpolated);
    if (system.cloth_slip <= options_.slip_tolerance) break;
  }
  system.fluid.finish();
  system.velocities = velocities_;
  system.positions = sum<Dim>(system.positions, dt, velocities_);
}

template class SemiImplicitCoupling<2>;
template class SemiImplicitCoupling<3>;

}  // namespace washfsi
