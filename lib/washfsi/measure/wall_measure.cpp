// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/wall_measure.hpp"

namespace washfsi {

template <int Dim>
WallMeasure<Dim>::WallMeasure(const System<Dim>& system)
    : system_(system),
      walls_(exposed_walls<Dim>(system.model.grid, system.model.boundary, system.model.body_list)),
      loads_(walls_.size()) {}

template <int Dim>
void WallMeasure<Dim>::declare(QuantityList& quantities) {
  for (std::size_t s = 0; s < walls_.size(); ++s) {
    const std::string name =
        std::string("wall_") + "xyz"[walls_[s].axis] + (walls_[s].end == End::lower ? "_lower" : "_upper");
    declare_load<Dim>(quantities, name, "/walls/" + name,
                      "of water and cloth on this side of the box, about the box's middle", loads_, s);
  }
}

template <int Dim>
void WallMeasure<Dim>::observe(const Observation<Dim>& seen) {
  const Model<Dim>& model = system_.model;
  loads_ = wall_loads<Dim>(model.grid, model.boundary, model.body_list, walls_, seen.velocity,
                           model.fluid.projection().pressure(), model.liquid.viscosity(), system_.state.clock.time);
  const Loads<Dim> of_markers = model.bodies.loads_on_sides(walls_);
  for (std::size_t s = 0; s < walls_.size(); ++s) loads_[s] += of_markers[s];
  for (std::size_t s = 0; s < walls_.size(); ++s)
    loads_[s] += seen.contact.sides[walls_[s].axis][walls_[s].end == End::upper ? 1 : 0];
}

template class WallMeasure<2>;
template class WallMeasure<3>;

}  // namespace washfsi
