// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/elasticity.hpp"

#include "washfsi/cloth/love.hpp"

namespace washfsi {

template <int Dim>
Elasticity<Dim>::Elasticity(const Cloths<Dim>& cloths, ElasticModel model) : cloths_(cloths), model_(model) {
  for (const LatticePart& part : cloths.lattices().parts())
    if (cloths.group_of(part).model == model) parts_.push_back(part);
}

template <int Dim>
std::string Elasticity<Dim>::origin() const {
  for (const auto& group : cloths_.groups())
    if (group.model == model_) return "-" + group.name + "_model " + name_of(model_);
  return "";
}

template <int Dim>
void Elasticity<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  const Points<Dim> x = cloths_.lattices().with_halo(positions);
  add_by_part(parts_, forces, [&](const LatticePart& part, std::span<Point<Dim>> of_part) {
    add_energy_forces<Dim>(cloths_.group_of(part).sheet, part.seen(x), of_part);
  });
}

template <int Dim>
void Elasticity<Dim>::add_energy(const Points<Dim>& positions, std::span<double> of_groups) const {
  const Points<Dim> x = cloths_.lattices().with_halo(positions);
  for (const LatticePart& part : parts_)
    of_groups[cloths_.pieces()[part.piece].group] +=
        elastic_energy<Dim>(cloths_.group_of(part).sheet, part.seen(x), part.own_begin, part.own_end);
}

template <int Dim>
void Elasticity<Dim>::add_force_rates(const Points<Dim>& positions, const Points<Dim>& direction,
                                      Points<Dim>& rates) const {
  const Points<Dim> x = cloths_.lattices().with_halo(positions), d = cloths_.lattices().with_halo(direction);
  add_by_part(parts_, rates, [&](const LatticePart& part, std::span<Point<Dim>> of_part) {
    add_energy_force_rates<Dim>(cloths_.group_of(part).sheet, part.seen(x), part.seen(d), of_part);
  });
}

template <int Dim>
void Elasticity<Dim>::visit_stiffness(const Points<Dim>& positions, GeometricStiffness geometric,
                                      const AddMarkerBlock<Dim>& add) const {
  const Points<Dim> x = cloths_.lattices().with_halo(positions);
  for (const LatticePart& part : parts_)
    add_energy_stiffness<Dim>(cloths_.group_of(part).sheet, part.seen(x), geometric,
                              [&](std::size_t row, std::size_t column, const StiffnessBlock<Dim>& block) {
                                if (row < part.own_begin || row >= part.own_end)
                                  return;  // another rank's, or incomplete here
                                add(part.markers[row], part.markers[column], block);
                              });
}

template <int Dim>
void Elasticity<Dim>::add_cancelling_size(const Points<Dim>& positions, std::span<double> sizes) const {
  for (std::size_t m = 0; m < positions.size(); ++m) {
    const ClothGroup<Dim>& group = cloths_.group_of(m);
    if (group.model == model_) sizes[m] += cancelling_size(group.sheet, positions[m].norm());
  }
}

template <int Dim>
void Elasticity<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  for (std::size_t m = 0; m < bounds.size(); ++m) {
    const ClothGroup<Dim>& group = cloths_.group_of(m);
    if (group.model == model_) bounds[m].stiffness += largest_stiffness(group.sheet);
  }
}

template <int Dim>
void StrongElasticity<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>&, Points<Dim>& forces) const {
  const Cloths<Dim>& cloths = this->cloths();
  const Points<Dim> x = cloths.lattices().with_halo(positions);
  add_by_part(this->parts(), forces, [&](const LatticePart& part, std::span<Point<Dim>> of_part) {
    add_love_forces(cloths.group_of(part).sheet, part.seen(x), of_part);
  });
}

template class Elasticity<2>;
template class Elasticity<3>;
template class StrongElasticity<2>;
template class StrongElasticity<3>;

}  // namespace washfsi
