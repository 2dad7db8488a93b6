// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/sheet_stiffness.hpp"

namespace washfsi {

namespace {

// Bending is linear: its stiffness is the same for every shape.
template <int Dim>
void add_bending_stiffness(const SheetLattice<Dim>& lattice, const AddBlock<Dim>& add) {
  const Sheet& sheet = lattice.sheet;
  const BendingModuli& bending = lattice.bending;
  const std::size_t m = lattice.m;
  const double area = sheet.part_area(), per_s = 1 / (sheet.ds * sheet.ds), per_r = 1 / (sheet.dr * sheet.dr);
  const std::array second_s{per_s, 0.0, -2 * per_s, 0.0, per_s}, second_r{0.0, per_r, -2 * per_r, per_r, 0.0};
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const double weight = area * lattice.share(k) * lattice.bend_weight(k);
    const bool along_s = lattice.bends_along_s(k), along_r = lattice.bends_along_r(k);
    ElementStiffness<Dim, 5> element({k - m, k - 1, k, k + 1, k + m});
    if (along_s) element.add(weight * bending.s, second_s, second_s);
    if (along_r) element.add(weight * bending.r, second_r, second_r);
    if (along_s && along_r) {
      element.add(area * bending.cross, second_s, second_r);
      element.add(area * bending.cross, second_r, second_s);
    }
    element.hand_on(add);
  }
}

}  // namespace

template <int Dim>
void add_energy_stiffness(const Sheet& sheet, std::span<const Point<Dim>> positions, GeometricStiffness geometric,
                          const AddBlock<Dim>& add) {
  const SheetLattice<Dim> lattice(sheet, positions);
  std::visit([&](const auto& law) { add_membrane_stiffness(law, lattice, geometric, add); }, sheet.fabric);
  add_bending_stiffness(lattice, add);
}

template void add_energy_stiffness<2>(const Sheet&, std::span<const Point<2>>, GeometricStiffness, const AddBlock<2>&);
template void add_energy_stiffness<3>(const Sheet&, std::span<const Point<3>>, GeometricStiffness, const AddBlock<3>&);

}  // namespace washfsi
