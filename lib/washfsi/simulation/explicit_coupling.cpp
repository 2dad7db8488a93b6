// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/explicit_coupling.hpp"

namespace washfsi {

namespace {

// Weight of the excess mass, and contact with the bodies as they are now.
template <int Dim>
void add_external_forces(System<Dim>& system, Points<Dim>& forces) {
  const std::vector<double> masses = system.cloths.marker_masses();
  system.contact_loads.assign(system.bodies.size(), {});
  const Points<Dim> contact = contact_forces<Dim>(system.contact, system.bodies, system.cloths, system.positions,
                                                  system.fluid.time(), system.contact_loads);
  for (std::size_t m = 0; m < forces.size(); ++m) forces[m] += masses[m] * system.gravity + contact[m];
}

// Places the bodies as they are at `time`.
template <int Dim>
void hold_bodies(System<Dim>& system, double time) {
  system.mask.update(time);
  if (!system.mask.extrapolates()) return;
  const petsc::LocalVector local(system.grid.wide_face_dm(), system.fluid.velocity());
  system.boundary.fill(local, system.fluid.time());
  system.mask.extrapolate(local, time);
}

}  // namespace

template <int Dim>
Points<Dim> marker_velocities(const System<Dim>& system) {
  const petsc::Vector masked = petsc::zeros_like(system.fluid.velocity());
  WASH_PETSC(VecCopy(system.fluid.velocity(), masked));
  system.mask.hold(masked);
  const petsc::LocalVector local(system.grid.wide_face_dm(), masked);
  system.boundary.fill(local, system.fluid.time());
  return system.transfer.interpolate(local);
}

template <int Dim>
void ExplicitCoupling<Dim>::advance(System<Dim>& system, double dt) {
  Points<Dim> forces = system.cloths.elastic_forces(system.positions, system.velocities);
  add_external_forces(system, forces);

  system.locate_cloth();
  WASH_PETSC(VecZeroEntries(system.force));
  system.wall_reaction = system.transfer.spread(forces, system.force);

  hold_bodies(system, system.fluid.time() + dt);
  system.fluid.advance(dt, {system.density, system.force, system.mask.constraint()});

  system.velocities = marker_velocities(system);
  for (std::size_t m = 0; m < system.positions.size(); ++m) system.positions[m] += dt * system.velocities[m];
}

template class ExplicitCoupling<2>;
template class ExplicitCoupling<3>;
template Points<2> marker_velocities<2>(const System<2>&);
template Points<3> marker_velocities<3>(const System<3>&);

}  // namespace washfsi
