// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/liquid.hpp"

namespace washfsi {

template <int Dim>
Liquid<Dim>::Liquid(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const PureLiquid& pure,
                    ViscosityModels<Dim> models, WallTreatment walls)
    : grid_(grid), boundary_(boundary), pure_(pure), models_(std::move(models)), density_(grid.face_vector()) {
  reset_density();
  if (walls != WallTreatment::none) walls_ = std::make_unique<WallModel<Dim>>(grid, boundary);
  if (models_.empty() && !walls_) return;
  global_viscosity_ = grid.cell_vector();
  WASH_PETSC(VecSet(global_viscosity_, pure.viscosity));
  varying_.emplace(grid);
  WASH_PETSC(VecSet(varying_->in_cells(), pure.viscosity));
  varying_->find_edges();
}

template <int Dim>
void Liquid<Dim>::set_own_density(Vec density) {
  if (!own_density_) own_density_ = grid_.face_vector();
  WASH_PETSC(VecCopy(density, own_density_));
  reset_density();
}

template <int Dim>
void Liquid<Dim>::reset_density() {
  if (own_density_)
    WASH_PETSC(VecCopy(own_density_, density_));
  else
    WASH_PETSC(VecSet(density_, pure_.density));
}

template <int Dim>
void Liquid<Dim>::update_viscosity(const StepFlow& flow, WallViscosity* bodies) {
  if (!varying_) return;
  const petsc::LogPart part("viscosity");
  const bool is_new = walls_time_ != flow.time;
  walls_time_ = flow.time;
  const CellShare<Dim> share(grid_, flow.fluid_share);
  let_models_add(flow, share);
  const petsc::GlobalVector all(grid_.cell_dm());  // kept, since measures read the models' viscosity later
  WASH_PETSC(VecCopy(global_viscosity_, all));
  if (bodies) {
    if (is_new) bodies->observe(flow, pure_);
    bodies->replace(all);
  }
  WASH_PETSC(DMGlobalToLocal(grid_.cell_dm(), all, INSERT_VALUES, varying_->in_cells()));
  boundary_.fill_cells(varying_->in_cells());
  if (walls_) {
    if (is_new) let_walls_follow(flow, share);
    walls_->set_ghosts(varying_->in_cells());
  }
  varying_->find_edges();
}

template <int Dim>
void Liquid<Dim>::let_walls_follow(const StepFlow& flow, const CellShare<Dim>& share) {
  const GhostedVelocity<Dim> local(boundary_, grid_.face_dm(), flow.velocity, flow.time);
  walls_->observe(ConstFaceView<Dim>(grid_.face_dm(), local), flow.last_step, pure_, share);
}

template <int Dim>
void Liquid<Dim>::let_models_add(const StepFlow& flow) {
  if (!models_.empty()) let_models_add(flow, CellShare<Dim>(grid_, flow.fluid_share));
}

template <int Dim>
void Liquid<Dim>::let_models_add(const StepFlow& flow, const CellShare<Dim>& share) {
  if (models_.empty()) return;
  WASH_PETSC(VecSet(global_viscosity_, pure_.viscosity));
  const GhostedVelocity<Dim> local(boundary_, grid_.face_dm(), flow.velocity, flow.time);
  const ConstFaceView<Dim> u(grid_.face_dm(), local);
  const CellView<Dim> mu(grid_.cell_dm(), global_viscosity_);
  for (const auto& model : models_) model->add(grid_, u, pure_, share, mu);
}

template class Liquid<2>;
template class Liquid<3>;

}  // namespace washfsi
