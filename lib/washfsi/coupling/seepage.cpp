// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/seepage.hpp"

#include <utility>

#include "washfsi/coupling/coupling_operations.hpp"

namespace washfsi {

template <int Dim>
Seepage<Dim>::Seepage(const Model<Dim>& model) : cloths_(model.cloths) {
  if (model.cloth_treatment.films_drain) films_.emplace(model.grid, cloths_, model.liquid);
  if (model.cloth_treatment.wall_model != WallTreatment::none) layers_.emplace(model);
  present_ = films_ || layers_;
  for (const auto& group : cloths_.groups()) present_ = present_ || group.permeance > 0;
  for (std::size_t m = 0; m < cloths_.owned(); ++m)
    rates_.push_back(cloths_.group_of(m).permeance / cloths_.marker_areas()[m]);
}

template <int Dim>
void Seepage<Dim>::begin_step(const State<Dim>& state, const Points<Dim>& forces, double dt) {
  if (films_) films_->begin_step(state.positions, forces);
  if (layers_) layers_->begin_step(state, dt);
}

template <int Dim>
void Seepage<Dim>::finish_step(const Points<Dim>& forces, State<Dim>& state) const {
  if (!layers_) return;
  state.slips_before = std::exchange(state.slips, layers_->slips(forces));
  state.water_forces = forces;
}

template <int Dim>
Points<Dim> Seepage<Dim>::velocities(const Points<Dim>& forces) const {
  Points<Dim> result;
  for (std::size_t m = 0; m < forces.size(); ++m) result.push_back(rates_[m] * forces[m]);
  if (films_) films_->add_velocities(forces, result);
  if (layers_) result += layers_->slips(forces);
  return result;
}

template <int Dim>
double Seepage<Dim>::power(const Points<Dim>& forces) const {
  return dot(cloths_.comm(), forces, velocities(forces));
}

// The blocks of B on its diagonal, films apart.
template <int Dim>
std::vector<Block<Dim>> Seepage<Dim>::own_blocks(double factor) const {
  std::vector<Block<Dim>> blocks;
  for (std::size_t m = 0; m < rates_.size(); ++m) {
    blocks.push_back(factor * rates_[m] * Block<Dim>::Identity());
    if (layers_) blocks.back() += factor * layers_->eases()[m];
  }
  return blocks;
}

template <int Dim>
void Seepage<Dim>::add_to(StepMobility<Dim>& mobility, double factor) const {
  if (!present_) return;
  if (films_) mobility.add(films_->matrix(factor));
  mobility.add_own(own_blocks(factor));
}

template class Seepage<2>;
template class Seepage<3>;

}  // namespace washfsi
