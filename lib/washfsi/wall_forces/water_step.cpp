// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/wall_forces/water_step.hpp"

namespace washfsi {

template <int Dim>
void WaterStep<Dim>::predict(const TimeStep& step, StepFields<Dim> fields) {
  if (walls_) walls_->begin_trial(step, fields.liquid.density);
  if (walls_) fields.force_fields.push_back(walls_);
  fluid_.predict(step, fields);
}

template <int Dim>
void WaterStep<Dim>::correct_slip_and_project() {
  if (walls_) walls_->reduce_slip(fluid_.intermediate_velocity(), WallForces<Dim>::Stage::predicted);
  fluid_.projection().project();
}

template <int Dim>
void WaterStep<Dim>::add_force(Vec force) {
  const petsc::LogPart part("pressure");
  fluid_.add_force(force);
  if (walls_) walls_->reduce_slip(fluid_.intermediate_velocity(), WallForces<Dim>::Stage::projected);
  if (fluid_.projection().is_on()) fluid_.projection().project_again();
}

template <int Dim>
void WaterStep<Dim>::enforce_no_slip() {
  if (!walls_ || !fluid_.projection().is_on()) return;
  const petsc::LogPart part("pressure");
  walls_->enforce_no_slip(fluid_.intermediate_velocity(), fluid_.projection());
}

template <int Dim>
void WaterStep<Dim>::finish() {
  fluid_.finish();
  if (walls_) walls_->accept();
}

template <int Dim>
void WaterStep<Dim>::advance(const TimeStep& step, const StepFields<Dim>& fields) {
  predict(step, fields);
  correct_slip_and_project();
  enforce_no_slip();
  finish();
}

template class WaterStep<2>;
template class WaterStep<3>;

}  // namespace washfsi
