// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/coupling_operations.hpp"

#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
Points<Dim> sum(const Points<Dim>& a, double factor, const Points<Dim>& b) {
  Points<Dim> result(a);
  for (std::size_t m = 0; m < result.size(); ++m) result[m] += factor * b[m];
  return result;
}

template <int Dim>
double norm(MPI_Comm comm, const Points<Dim>& values) {
  double squares = 0;
  for (const auto& value : values) squares += value.squaredNorm();
  return std::sqrt(ordered_sum(comm, squares));
}

template <int Dim>
Points<Dim> external_forces(System<Dim>& system, const Points<Dim>& positions, double time) {
  const std::vector<double>& masses = system.cloths.marker_masses();
  system.contact_loads = {Loads<Dim>(system.bodies.size()), {}};
  Points<Dim> forces = contact_forces<Dim>(system.contact, system.bodies, system.boundary, system.grid, system.cloths,
                                           positions, time, system.contact_loads);
  for (std::size_t m = 0; m < forces.size(); ++m)
    forces[m] += masses[m] * system.gravity + system.cloths.dead_loads()[m];
  return forces;
}

template <int Dim>
Points<Dim> all_forces(System<Dim>& system, const Points<Dim>& positions, const Points<Dim>& velocities, double time) {
  const Points<Dim> elastic = system.cloths.elastic_forces(positions);
  return sum<Dim>(sum<Dim>(elastic, 1, system.cloths.damping_forces(positions, velocities)), 1,
                  external_forces(system, positions, time));
}

template <int Dim>
void spread_cloth(System<Dim>& system, const Points<Dim>& positions, const Points<Dim>& forces) {
  system.locate_cloth(positions);
  WASH_PETSC(VecZeroEntries(system.force));
  system.wall_reaction = system.transfer.spread(forces, system.force);
}

template <int Dim>
void hold_bodies(System<Dim>& system, double time) {
  system.mask.update(time);
  if (!system.mask.extrapolates()) return;
  const GhostedVelocity<Dim> local(system.boundary, system.grid.wide_face_dm(), system.fluid.velocity(),
                                   system.fluid.time());
  system.mask.extrapolate(local, time);
}

template <int Dim>
void predict_and_project(System<Dim>& system, double dt) {
  system.fluid.predict(dt, {system.density, system.force, system.mask.constraint()});
  system.fluid.project();
}

template <int Dim>
Points<Dim> marker_velocities(const System<Dim>& system, Vec velocity, double time) {
  const petsc::GlobalVector masked(system.grid.face_dm());
  WASH_PETSC(VecCopy(velocity, masked));
  system.mask.hold(masked);
  const GhostedVelocity<Dim> local(system.boundary, system.grid.wide_face_dm(), masked, time);
  return system.transfer.interpolate(local);
}

template Points<2> sum<2>(const Points<2>&, double, const Points<2>&);
template Points<3> sum<3>(const Points<3>&, double, const Points<3>&);
template double norm<2>(MPI_Comm, const Points<2>&);
template double norm<3>(MPI_Comm, const Points<3>&);
template Points<2> all_forces<2>(System<2>&, const Points<2>&, const Points<2>&, double);
template Points<3> all_forces<3>(System<3>&, const Points<3>&, const Points<3>&, double);
template Points<2> external_forces<2>(System<2>&, const Points<2>&, double);
template Points<3> external_forces<3>(System<3>&, const Points<3>&, double);
template void spread_cloth<2>(System<2>&, const Points<2>&, const Points<2>&);
template void spread_cloth<3>(System<3>&, const Points<3>&, const Points<3>&);
template void hold_bodies<2>(System<2>&, double);
template void hold_bodies<3>(System<3>&, double);
template void predict_and_project<2>(System<2>&, double);
template void predict_and_project<3>(System<3>&, double);
template Points<2> marker_velocities<2>(const System<2>&, Vec, double);
template Points<3> marker_velocities<3>(const System<3>&, Vec, double);

}  // namespace washfsi
