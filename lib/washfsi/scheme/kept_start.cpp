// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/scheme/kept_start.hpp"

#include <algorithm>

#include "washfsi/scheme/coupling_operations.hpp"

namespace washfsi {

namespace {

template <int Dim>
std::vector<Vec> fields_of(const FractionalStep<Dim>& fluid) {
  std::vector<Vec> fields;
  for (const auto& [name, field] : fluid.face_state()) fields.push_back(field);
  for (const auto& [name, field] : fluid.cell_state()) fields.push_back(field);
  return fields;
}

}  // namespace

template <int Dim>
KeptStart<Dim>::KeptStart(const System<Dim>& system)
    : last_step_(system.model.fluid.last_step()),
      step_before_last_(system.model.fluid.step_before_last()),
      counts_(system.model.fluid.counts()),
      knows_cover_(system.model.boundary.knows_cover()),
      state_(system.state),
      force_(petsc::copy_of(system.step.force)),
      pushed_at_(system.step.pushed_at),
      given_(system.step.given),
      cloth_iterations_(system.step.cloth_iterations) {
  const Model<Dim>& model = system.model;
  for (const Vec field : fields_of(model.fluid)) fields_.push_back(petsc::copy_of(field));
  const auto driving = model.fluid.driving().kept();
  driving_.assign(driving.begin(), driving.end());
  for (const auto& layer : model.boundary.outflows()) outflows_.push_back(layer.kept());
  if (!model.walls) return;
  wall_forces_ = model.walls->kept();
  wall_pushes_ = model.walls->known_pushes().kept();
  push_count_ = model.walls->known_pushes().size();
}

// What laws of walls have seen of the flow at a start they have seen then, too.
template <int Dim>
void KeptStart<Dim>::restore(System<Dim>& system) const {
  auto& [model, state, step] = system;
  state = state_;
  restore_fluid(model);
  model.locate_cloth(state.positions);
  model.mask.update(state.clock.time);
  hold_walls(model, state.clock.time);
  if (!knows_cover_) model.boundary.forget_cover();
  if (model.walls) {
    model.walls->kept() = wall_forces_;
    model.walls->known_pushes().take(wall_pushes_, push_count_);
  }
  WASH_PETSC(VecCopy(force_, step.force));
  step.pushed_at = pushed_at_;
  step.given = given_;
  step.cloth_iterations = cloth_iterations_;
  step.cloth_slip = step.seepage_power = 0;
  step.wall_reaction.setZero();
}

template <int Dim>
void KeptStart<Dim>::restore_fluid(Model<Dim>& model) const {
  const std::vector<Vec> fields = fields_of(model.fluid);
  for (std::size_t f = 0; f < fields.size(); ++f) WASH_PETSC(VecCopy(fields_[f], fields[f]));
  model.fluid.set_last_steps(last_step_, step_before_last_);
  model.fluid.set_counts(counts_);
  std::ranges::copy(driving_, model.fluid.driving().kept().begin());
  auto& outflows = model.boundary.outflows();
  for (std::size_t n = 0; n < outflows.size(); ++n) outflows[n].keep(outflows_[n]);
  model.boundary.set_outflow_time(state_.clock.time);
}

template class KeptStart<2>;
template class KeptStart<3>;

}  // namespace washfsi
