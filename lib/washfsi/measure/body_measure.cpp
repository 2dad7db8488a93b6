// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/body_measure.hpp"

#include <utility>

#include "washfsi/mask/mask_loads.hpp"
#include "washfsi/wall_forces/marker_loads.hpp"

namespace washfsi {

namespace {

// 0 for a body that never moves.
template <int Dim>
std::vector<CycleFigure> power_figures(const Body<Dim>& body) {
  if (body.motion.at_rest()) return {};
  std::vector<CycleFigure> figures = mean_peak_rms(body.name + "_power", Units<Dim>::power, "power of the body");
  figures.insert(figures.begin(), {body.name + "_work", Units<Dim>::energy, OverCycle::integral,
                                   "that the body puts into the water and cloth", 1, true});
  return figures;
}

}  // namespace

template <int Dim>
BodyMeasure<Dim>::BodyMeasure(const System<Dim>& system, bool balance)
    : system_(system),
      loads_(system.model.body_list.size()),
      balance_loads_(system.model.body_list.size()),
      powers_(system.model.body_list.size(), 0.0),
      slips_(system.model.body_list.size(), 0.0) {
  const Model<Dim>& model = system.model;
  if (balance && !loads_.empty()) control_volumes_.emplace(model.grid, model.boundary, model.body_list);
}

template <int Dim>
void BodyMeasure<Dim>::declare(QuantityList& quantities) {
  if (!system_.model.body_list.empty())
    quantities.add({"mask_dissipation", Units<Dim>::power,
                    "what moving walls gave beyond their power on the water: at the staircase of a mask, or as markers "
                    "move in a step",
                    [this] { return mask_dissipation_; }},
                   {{"mask_dissipated", Units<Dim>::energy, OverCycle::integral, "energy lost at moving walls", -1}});
  for (std::size_t b = 0; b < loads_.size(); ++b) {
    const std::string name = system_.model.body_list[b].name, pointer = "/bodies/" + name;
    declare_load<Dim>(quantities, name, pointer, "of water and cloth on the body, about its centre", loads_, b);
    quantities.add({name + "_power", Units<Dim>::power, "that the body puts into the water and cloth",
                    [this, b] { return powers_[b]; }, Accumulation::none, pointer + "/power"},
                   power_figures(system_.model.body_list[b]));
    quantities.add({"", Units<Dim>::torque, "torque about the axis in which it turns",
                    [this, b] { return loads_[b].torque[rotation_components<Dim> - 1]; }},
                   mean_peak_rms(name + "_torque", Units<Dim>::torque, "torque of water and cloth on the body", true));
    if (system_.model.bodies.wall_forces())
      quantities.add(
          {name + "_slip", "m/s",
           "what the water's velocity at the body's markers differs by from theirs after the step, root mean "
           "square; not what `-wall_model` lets slide",
           [this, b] { return slips_[b]; }, Accumulation::largest, pointer + "/max_slip"});
    if (control_volumes_)
      declare_load<Dim>(quantities, name + "_balance", pointer + "/balance",
                        "the same by the balance of momentum round the body", balance_loads_, b);
  }
}

template <int Dim>
Loads<Dim> BodyMeasure<Dim>::inner_momenta() const {
  const Model<Dim>& model = system_.model;
  return inner_momentum(model.bodies.mask(), model.fluid.velocity(), model.liquid.density(), system_.state.clock.time);
}

template <int Dim>
void BodyMeasure<Dim>::prepare() {
  if (system_.model.bodies.wall_forces()) inner_momenta_ = inner_momenta();
}

// The part missing in the loads: the growth of the momentum of the water inside.
template <int Dim>
Loads<Dim> BodyMeasure<Dim>::inner_inertia(double dt) {
  Loads<Dim> inertia(loads_.size());
  if (!system_.model.bodies.wall_forces()) return inertia;
  const Loads<Dim> before = std::exchange(inner_momenta_, inner_momenta());
  for (std::size_t b = 0; b < inertia.size(); ++b)
    inertia[b] = {(inner_momenta_[b].force - before[b].force) / dt, (inner_momenta_[b].torque - before[b].torque) / dt};
  return inertia;
}

template <int Dim>
void BodyMeasure<Dim>::observe_markers(const WallForces<Dim>& walls, double dt) {
  const FractionalStep<Dim>& fluid = system_.model.fluid;
  const double time = system_.state.clock.time;
  const Points<Dim> after =
      walls.markers().water_velocities(fluid.velocity(), time);  // known already from enforcing no slip
  const Points<Dim> before = walls.markers().water_velocities(fluid.velocity_before(), time - dt);
  mask_dissipation_ = lost_power(walls, before, after, dt);
  slips_ = slip_of_bodies(walls.markers(), after);
}

template <int Dim>
void BodyMeasure<Dim>::observe(const Observation<Dim>& seen) {
  if (loads_.empty()) return;
  const Model<Dim>& model = system_.model;
  const FractionalStep<Dim>& fluid = model.fluid;
  const Vec density = model.liquid.density();
  const double time = system_.state.clock.time, middle = time - 0.5 * seen.dt;
  loads_ = model.bodies.water_loads({.constraint_force = fluid.constraint_force(),
                                     .density = density,
                                     .pressure = fluid.projection().pressure(),
                                     .local_velocity = seen.velocity,
                                     .viscosity = model.liquid.viscosity(),
                                     .time = time,
                                     .dt = seen.dt});
  const Loads<Dim> of_inner = inner_inertia(seen.dt);
  if (control_volumes_)
    balance_loads_ = control_volumes_->loads({fluid.velocity_before(), fluid.velocity(), fluid.projection().pressure(),
                                              density, system_.step.force, model.bodies.fluid_share(),
                                              model.liquid.viscosity(), time, seen.dt, fluid.driving().gradient()});
  for (std::size_t b = 0; b < loads_.size(); ++b)
    for (Load<Dim>* load : {&loads_[b], &balance_loads_[b]}) (*load += of_inner[b]) += seen.contact.bodies[b];
  if (!model.bodies.wall_forces())
    mask_dissipation_ = mask_dissipation(model.bodies.mask(), fluid.velocity_before(), density, seen.dt);
  else
    observe_markers(*model.bodies.wall_forces(), seen.dt);
  for (std::size_t b = 0; b < loads_.size(); ++b) powers_[b] = power(model.body_list[b].motion, loads_[b], middle);
}

template class BodyMeasure<2>;
template class BodyMeasure<3>;

}  // namespace washfsi
