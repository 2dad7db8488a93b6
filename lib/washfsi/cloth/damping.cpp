// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/damping.hpp"

#include <algorithm>

namespace washfsi {

template <int Dim>
Damping<Dim>::Damping(const Cloths<Dim>& cloths)
    : cloths_(cloths), any_(std::any_of(cloths.groups().begin(), cloths.groups().end(), [](const auto& group) {
        return group.sheet.damping > 0;
      })) {}

template <int Dim>
void Damping<Dim>::add_force(const Points<Dim>& positions, const Points<Dim>& velocities, Points<Dim>& forces) const {
  if (!any_) return;
  const Points<Dim> x = cloths_.lattices().with_halo(positions), u = cloths_.lattices().with_halo(velocities);
  add_by_part(cloths_.lattices().parts(), forces, [&](const LatticePart& part, std::span<Point<Dim>> of_part) {
    add_damping_forces<Dim>(cloths_.group_of(part).sheet, part.seen(x), part.seen(u), of_part);
  });
}

template <int Dim>
void Damping<Dim>::add_bound(std::span<StiffnessBound> bounds) const {
  for (std::size_t m = 0; m < bounds.size(); ++m) bounds[m].damping += cloths_.group_of(m).sheet.damping;
}

template class Damping<2>;
template class Damping<3>;

}  // namespace washfsi
