// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/bodies/bodies.hpp"

#include "washfsi/mask/mask_loads.hpp"
#include "washfsi/wall_forces/marker_loads.hpp"

namespace washfsi {

namespace {

template <int Dim>
std::unique_ptr<WallForces<Dim>> make_walls(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                            const std::vector<Body<Dim>>& list, BodyTreatment treatment,
                                            const FluidOptions<Dim>& fluid) {
  if (treatment.method != BodyMethod::direct_forcing || list.empty()) return nullptr;
  treatment.limits_advection &= fluid.advects_centrally();
  return std::make_unique<WallForces<Dim>>(grid, boundary, list, treatment);
}

}  // namespace

template <int Dim>
Bodies<Dim>::Bodies(const Grid<Dim>& grid, Boundary<Dim>& boundary, const std::vector<Body<Dim>>& list,
                    const BodyTreatment& treatment, const FluidOptions<Dim>& fluid)
    : grid_(grid),
      boundary_(boundary),
      list_(list),
      mask_(grid, list, treatment),
      walls_(make_walls(grid, boundary, list, treatment, fluid)) {
  if (walls_ && fluid.wall_model != WallTreatment::none)
    law_ = std::make_unique<BodyWallLaw<Dim>>(grid, boundary, list, walls_->markers().layout());
  count_sliding_water();
}

template <int Dim>
void Bodies<Dim>::place(double time, Vec velocity, double time_of_velocity) {
  place(time);
  if (!mask_.extrapolates()) return;
  const GhostedVelocity<Dim> local(boundary_, grid_.wide_face_dm(), velocity, time_of_velocity);
  mask_.extrapolate(local, time);
}

// The sides beneath bodies move with them.
template <int Dim>
void Bodies<Dim>::place(double time) {
  mask_.update(time);
  if (!walls_) return;
  const PosedBodies<Dim> posed(list_, time);
  boundary_.covers().set(time, mask_.cover(posed));
  walls_->place(time);
  count_sliding_water();
}

template <int Dim>
void Bodies<Dim>::count_sliding_water() {
  if (law_ && walls_->markers().nearness()) mask_.count_as_water(walls_->markers().nearness());
}

template <int Dim>
void Bodies<Dim>::let_water_slide() {
  if (!law_) return;
  walls_->let_slide(*law_);
  mask_.let_slide([this](Vec fraction, Vec velocity) { law_->add_inner_slip(fraction, velocity); });
}

template <int Dim>
Loads<Dim> Bodies<Dim>::water_loads(const WaterAtBodies& water) const {
  Loads<Dim> loads =
      constraint_loads(mask_, water.constraint_force, water.density, water.pressure, water.time - 0.5 * water.dt);
  const Loads<Dim> beneath = hidden_wall_shear(mask_, boundary_, water.local_velocity, water.viscosity, water.time);
  const Loads<Dim> of_markers = walls_ ? marker_loads(*walls_) : Loads<Dim>(loads.size());
  for (std::size_t b = 0; b < loads.size(); ++b) (loads[b] += beneath[b]) += of_markers[b];
  return loads;
}

template <int Dim>
Loads<Dim> Bodies<Dim>::loads_on_sides(const std::vector<SideName>& sides) const {
  return walls_ ? marker_loads_on_sides(*walls_, sides) : Loads<Dim>(sides.size());
}

template <int Dim>
void Bodies<Dim>::register_state(StateList& state) {
  if (walls_) walls_->register_state(state);
  if (law_) law_->register_state(state);
}

template class Bodies<2>;
template class Bodies<3>;

}  // namespace washfsi
