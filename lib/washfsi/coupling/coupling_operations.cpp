// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/coupling_operations.hpp"

#include <cmath>

#include "washfsi/coupling/step_bound.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
double dot(MPI_Comm comm, const Points<Dim>& a, const Points<Dim>& b) {
  double sum = 0;
  for (std::size_t m = 0; m < a.size(); ++m) sum += a[m].dot(b[m]);
  return ordered_sum(comm, sum);
}

template <int Dim>
double norm(MPI_Comm comm, const Points<Dim>& values) {
  return std::sqrt(dot(comm, values, values));
}

template <int Dim>
void begin_step(System<Dim>& system, const Points<Dim>& positions, double time, double dt,
                const Acceleration<Dim>& acceleration, double share) {
  system.model.forces.begin_step({positions, system.state.velocities, time, dt, acceleration, {}, share});
}

template <int Dim>
void begin_explicit_step(System<Dim>& system, const Points<Dim>& positions, double time, double dt) {
  Model<Dim>& model = system.model;
  if (model.has_fluid) model.locate_cloth(positions);
  ExplicitStep lagged{dt, {}};
  if (have_friction(model.forces)) {
    lagged.mobilities = mobility_per_area<Dim>(model);
    for (std::size_t m = 0; m < lagged.mobilities.size(); ++m) lagged.mobilities[m] /= model.cloths.marker_areas()[m];
  }
  model.forces.begin_step({positions, system.state.velocities, time, 0, {}, std::move(lagged)});
}

template <int Dim>
Points<Dim> all_forces(System<Dim>& system, const Points<Dim>& positions) {
  system.step.evaluated_at = positions;
  return system.model.forces.all(positions, system.state.velocities);
}

template <int Dim>
void spread_cloth(System<Dim>& system, const Points<Dim>& forces) {
  auto& [model, state, step] = system;
  WASH_PETSC(VecZeroEntries(step.force));
  step.force_on_water = forces;
  step.side_reaction = model.transfer.spread_with_reaction(forces, step.force);
}

template <int Dim>
void place_bodies(System<Dim>& system, double time) {
  Model<Dim>& model = system.model;
  model.bodies.place(time, model.fluid.velocity(), system.state.clock.time);
}

template <int Dim>
void predict_water(System<Dim>& system, double dt) {
  auto& [model, state, step] = system;
  model.liquid.update_viscosity(
      {model.fluid.velocity(), state.clock.time, model.bodies.fluid_share(), model.fluid.last_step()},
      model.bodies.wall_law());
  model.bodies.let_water_slide();
  StepFields<Dim> fields{.liquid = model.liquid.fields(),
                         .force = step.force,
                         .constraint = model.bodies.constraint(),
                         .upwind_weight = model.upwind_weight(),
                         .driven_share = model.bodies.driven_share()};
  for (const auto& force : model.water_forces) fields.force_fields.push_back(force.get());
  model.water_step().predict(state.clock.next(dt), fields);
}

template <int Dim>
void move_water(System<Dim>& system, double dt) {
  predict_water(system, dt);
  system.model.water_step().correct_slip_and_project();
  system.model.water_step().enforce_no_slip();
}

template <int Dim>
Points<Dim> marker_velocities(const Model<Dim>& model, Vec velocity, double time) {
  const petsc::GlobalVector masked(model.grid.face_dm());
  WASH_PETSC(VecCopy(velocity, masked));
  model.bodies.apply(masked);
  const GhostedVelocity<Dim> local(model.boundary, model.grid.wide_face_dm(), masked, time);
  return model.transfer.interpolate(local);
}

template <int Dim>
Points<Dim> moved(System<Dim>& system, const Points<Dim>& motion) {
  return system.state.positions + system.model.forces.shortened(system.state.positions, motion);
}

template double dot<2>(MPI_Comm, const Points<2>&, const Points<2>&);
template double dot<3>(MPI_Comm, const Points<3>&, const Points<3>&);
template double norm<2>(MPI_Comm, const Points<2>&);
template double norm<3>(MPI_Comm, const Points<3>&);
template void begin_step<2>(System<2>&, const Points<2>&, double, double, const Acceleration<2>&, double);
template void begin_step<3>(System<3>&, const Points<3>&, double, double, const Acceleration<3>&, double);
template void begin_explicit_step<2>(System<2>&, const Points<2>&, double, double);
template void begin_explicit_step<3>(System<3>&, const Points<3>&, double, double);
template Points<2> all_forces<2>(System<2>&, const Points<2>&);
template Points<3> all_forces<3>(System<3>&, const Points<3>&);
template void spread_cloth<2>(System<2>&, const Points<2>&);
template void spread_cloth<3>(System<3>&, const Points<3>&);
template void place_bodies<2>(System<2>&, double);
template void place_bodies<3>(System<3>&, double);
template void predict_water<2>(System<2>&, double);
template void predict_water<3>(System<3>&, double);
template void move_water<2>(System<2>&, double);
template void move_water<3>(System<3>&, double);
template Points<2> marker_velocities<2>(const Model<2>&, Vec, double);
template Points<3> marker_velocities<3>(const Model<3>&, Vec, double);
template Points<2> moved<2>(System<2>&, const Points<2>&);
template Points<3> moved<3>(System<3>&, const Points<3>&);

}  // namespace washfsi
