// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/semi_implicit_coupling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "washfsi/simulation/coupling_operations.hpp"
#include "washfsi/simulation/marker_vectors.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
SemiImplicitCoupling<Dim>::SemiImplicitCoupling(const System<Dim>& system, const CouplingOptions& options)
    : options_(options),
      solver_(system.cloths, system.positions,
              {SNESNEWTONLS, options.mobility == "row_sums", options.mobility == "matrix"}),
      matrix_(system.grid, system.transfer.delta()) {}

template <int Dim>
double SemiImplicitCoupling<Dim>::step_bound(const System<Dim>&) const {
  return std::numeric_limits<double>::infinity();
}

// Within solids, where nothing moves a marker, the row sums have a floor.
template <int Dim>
void SemiImplicitCoupling<Dim>::find_mobility(const System<Dim>& system, const Points<Dim>& places) {
  const petsc::LogPart part("mobility");
  constexpr double floor = 1e-3;
  const Vec share = system.mask.empty() ? nullptr : system.mask.fluid_fraction();
  row_sums_ = row_sum_mobility<Dim>(system.transfer, system.grid, system.boundary, system.density, share,
                                    std::vector<double>(places.size(), 1.0));
  double most = 0;
  for (const double sum : row_sums_) most = std::max(most, sum);
  most = largest(system.grid.comm(), most);
  for (double& sum : row_sums_) sum = options_.mobility_factor * std::max(sum, floor * most);
  if (options_.mobility == "matrix")
    matrix_.assemble(system.cloths.of_all_ranks(places), system.cloths.begin(), row_sums_);
}

template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::move_elastically(System<Dim>& system, double dt,
                                                        const Points<Dim>& free_velocities, const Points<Dim>& forces) {
  const petsc::LogPart part("cloth_solve");
  const MPI_Comm comm = system.grid.comm();
  const double tolerance = options_.tolerance * std::hypot(norm(comm, free_velocities), norm(comm, velocities_));
  return options_.mobility == "matrix" ? move_by_matrix(system, dt, free_velocities, forces, tolerance)
                                       : move_by_row_sums(system, dt, free_velocities, forces, tolerance);
}

// V - U - dt M (F' - F) = 0
template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::move_by_matrix(System<Dim>& system, double dt,
                                                      const Points<Dim>& free_velocities, const Points<Dim>& forces,
                                                      double tolerance) {
  const Cloths<Dim>& cloths = system.cloths;
  const auto residual = [&](const Points<Dim>& velocities) {
    const Points<Dim> moved = cloths.elastic_forces(sum<Dim>(system.positions, dt, velocities));
    const Points<Dim> gained = product<Dim>(matrix_, sum<Dim>(moved, -1, forces));
    return sum<Dim>(sum<Dim>(velocities, -1, free_velocities), -dt, gained);
  };
  Points<Dim> linearised_at;
  const auto assemble = [&](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    linearised_at = sum<Dim>(system.positions, dt, velocities);
    cloths.set_stiffness(linearised_at, geometric, dt * dt, matrix);
    scale_and_shift<Dim>(row_sums_, std::vector<double>(row_sums_.size(), 1.0), matrix);
  };
  const auto jacobian = [&](const Points<Dim>& direction) {
    return sum<Dim>(direction, dt * dt, product<Dim>(matrix_, cloths.stiffness_product(linearised_at, direction)));
  };
  double most = 0;
  for (const double sum : row_sums_) most = std::max(most, sum);
  const double round_off = 10 * dt * largest(system.grid.comm(), most) * cloths.force_round_off(system.positions);
  Points<Dim> velocities = velocities_;
  system.cloth_iterations +=
      static_cast<double>(solver_.solve({residual, assemble, round_off, {}, jacobian}, tolerance, velocities));
  return velocities;
}

// D^-1 (V - U) - dt (F' - F) = 0, the gradient of a potential
template <int Dim>
Points<Dim> SemiImplicitCoupling<Dim>::move_by_row_sums(System<Dim>& system, double dt,
                                                        const Points<Dim>& free_velocities, const Points<Dim>& forces,
                                                        double tolerance) {
  const Cloths<Dim>& cloths = system.cloths;
  const auto residual = [&](const Points<Dim>& velocities) {
    const Points<Dim> moved = cloths.elastic_forces(sum<Dim>(system.positions, dt, velocities));
    Points<Dim> result(velocities.size());
    for (std::size_t m = 0; m < result.size(); ++m)
      result[m] = (velocities[m] - free_velocities[m]) / row_sums_[m] - dt * (moved[m] - forces[m]);
    return result;
  };
  std::vector<double> inverse;
  for (const double sum : row_sums_) inverse.push_back(1 / sum);
  const auto assemble = [&](const Points<Dim>& velocities, GeometricStiffness geometric, Mat matrix) {
    cloths.set_stiffness(sum<Dim>(system.positions, dt, velocities), geometric, dt * dt, matrix);
    scale_and_shift<Dim>(std::vector<double>(inverse.size(), 1.0), inverse, matrix);
  };
  const auto potential = [&](const Points<Dim>& velocities) {
    double work = 0;
    for (std::size_t m = 0; m < velocities.size(); ++m)
      work += 0.5 * inverse[m] * (velocities[m] - free_velocities[m]).squaredNorm() + dt * forces[m].dot(velocities[m]);
    const std::vector<double> energies = cloths.elastic_energies(sum<Dim>(system.positions, dt, velocities));
    return std::accumulate(energies.begin(), energies.end(), ordered_sum(system.grid.comm(), work));
  };
  double squares = 0;
  for (const double value : inverse) squares += value * value;
  const double weight =
      std::sqrt(ordered_sum(system.grid.comm(), squares) / static_cast<double>(cloths.marker_count()));
  const double round_off = 10 * dt * cloths.force_round_off(system.positions);
  Points<Dim> velocities = velocities_;
  system.cloth_iterations +=
      static_cast<double>(solver_.solve({residual, assemble, round_off, potential}, weight * tolerance, velocities));
  return velocities;
}

template <int Dim>
double SemiImplicitCoupling<Dim>::slip(const System<Dim>& system, const Points<Dim>& interpolated) const {
  const double speed = norm(system.grid.comm(), velocities_);
  return speed > 0 ? norm(system.grid.comm(), sum<Dim>(velocities_, -1, interpolated)) / speed : 0;
}

template <int Dim>
void SemiImplicitCoupling<Dim>::advance(System<Dim>& system, double dt) {
  const double time = system.fluid.time();
  Points<Dim> forces = system.cloths.elastic_forces(system.positions);
  const Points<Dim> places = sum<Dim>(system.positions, 0.5 * dt, system.velocities);
  spread_cloth(system, places, sum<Dim>(forces, 1, external_forces(system, system.positions, time)));
  hold_bodies(system, time + dt);
  predict_and_project(system, dt);

  velocities_ = system.velocities;
  find_mobility(system, places);
  Points<Dim> interpolated = marker_velocities<Dim>(system, system.fluid.next_velocity(), time + dt);
  const petsc::GlobalVector increment(system.grid.face_dm());
  for (PetscInt sweep = 0; sweep < options_.sweeps; ++sweep) {
    velocities_ = move_elastically(system, dt, interpolated, forces);
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
