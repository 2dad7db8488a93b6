// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/system_state.hpp"

#include <array>

#include "washfsi/coupling/coupling_operations.hpp"
#include "washfsi/grid/field_slab.hpp"

namespace washfsi {

namespace {

template <int Dim>
void register_motion(System<Dim>& system, StateList& list) {
  State<Dim>& state = system.state;
  list.add_number("/time", state.clock.time);
  list.add_number("/step", state.clock.step);
  const Slab slab = system.model.cloths.slab(Dim);
  const std::array<std::pair<const char*, Points<Dim>*>, 5> of_markers{{{"position", &state.positions},
                                                                        {"velocity", &state.velocities},
                                                                        {"velocity_before", &state.velocities_before},
                                                                        {"mean_velocity", &state.mean_velocities},
                                                                        {"force_before", &state.forces_before}}};
  for (const auto& [name, points] : of_markers)
    list.add(points_entry<Dim>(std::string("/cloth/") + name, slab, *points));
  if (system.model.cloth_treatment.wall_model == WallTreatment::none) return;
  list.add(points_entry<Dim>("/cloth/slip", slab, state.slips));
  list.add(points_entry<Dim>("/cloth/slip_before", slab, state.slips_before));
  list.add(points_entry<Dim>("/cloth/water_force", slab, state.water_forces));
}

// Registers the results of the previous step, which only a repeated step needs: a restarted run measures them anew.
template <int Dim>
void register_record(System<Dim>& system, StateList& list) {
  StepRecord<Dim>& step = system.step;
  const Slab slab = system.model.cloths.slab(Dim);
  list.add_number("/cloth/iterations", step.cloth_iterations);
  constexpr auto retake = StateEntry::Use::retake;
  list.add(vector_entry("/record/force", field_slab(system.model.grid, Dim), step.force)).use = retake;
  list.add(points_entry<Dim>("/record/evaluated_at", slab, step.evaluated_at)).use = retake;
  list.add(points_entry<Dim>("/record/given", slab, step.force_on_water)).use = retake;
}

template <int Dim>
StateList state_of(System<Dim>& system) {
  StateList list;
  register_state(system, list);
  return list;
}

}  // namespace

template <int Dim>
void register_state(System<Dim>& system, StateList& list) {
  Model<Dim>& model = system.model;
  register_motion(system, list);
  register_record(system, list);
  model.fluid.register_state(list);
  model.boundary.register_state(list);
  for (const auto& force : model.forces.list()) force->register_state(list);
  if (model.liquid.walls()) model.liquid.walls()->register_state(list);
  model.bodies.register_state(list);
}

template <int Dim>
void resume(System<Dim>& system) {
  Model<Dim>& model = system.model;
  model.locate_cloth(system.state.positions);
  model.bodies.place(system.state.clock.time);
}

template <int Dim>
SavedStart<Dim>::SavedStart(System<Dim>& system)
    : system_(system), knows_cover_(system.model.boundary.covers().are_known()), state_(state_of(system)) {}

template <int Dim>
void SavedStart<Dim>::restore() const {
  state_.restore();
  resume(system_);
  if (!knows_cover_) system_.model.boundary.covers().forget();
  StepRecord<Dim>& step = system_.step;
  step.cloth_slip = step.seepage_power = 0;
  step.side_reaction.setZero();
}

template void register_state<2>(System<2>&, StateList&);
template void register_state<3>(System<3>&, StateList&);
template void resume<2>(System<2>&);
template void resume<3>(System<3>&);
template class SavedStart<2>;
template class SavedStart<3>;

}  // namespace washfsi
