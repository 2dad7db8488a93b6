// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/sheet_membrane.hpp"

namespace washfsi {

namespace {

template <int Dim>
void add_bending_forces(const SheetLattice<Dim>& lattice, std::span<Point<Dim>> forces) {
  const Sheet& sheet = lattice.sheet;
  const std::size_t m = lattice.m;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const Moments<Dim> moments(lattice, k);
    if (lattice.bends_along_s(k)) {
      const Point<Dim> couple = lattice.share(k) * sheet.dr / sheet.ds * moments.s;
      forces[k - m] -= couple;
      forces[k] += 2 * couple;
      forces[k + m] -= couple;
    }
    if (lattice.bends_along_r(k)) {
      const Point<Dim> couple = lattice.share(k) * sheet.ds / sheet.dr * moments.r;
      forces[k - 1] -= couple;
      forces[k] += 2 * couple;
      forces[k + 1] -= couple;
    }
    if (lattice.has_quad(k)) {
      const Point<Dim> couple = 2 * lattice.bending.twist * lattice.twist_weight(k) * lattice.mixed_difference(k);
      forces[k] -= couple;
      forces[k + 1] += couple;
      forces[k + m] += couple;
      forces[k + m + 1] -= couple;
    }
  }
}

}  // namespace

template <int Dim>
void add_energy_forces(const Sheet& sheet, std::span<const Point<Dim>> positions, std::span<Point<Dim>> forces) {
  const SheetLattice<Dim> lattice(sheet, positions);
  add_membrane_forces(lattice, resultants_of(lattice, strains_of(lattice)), forces);
  add_bending_forces(lattice, forces);
}

template <int Dim>
void add_energy_force_rates(const Sheet& sheet, std::span<const Point<Dim>> positions,
                            std::span<const Point<Dim>> direction, std::span<Point<Dim>> rates) {
  const SheetLattice<Dim> lattice(sheet, positions), change(sheet, direction);
  std::visit([&](const auto& law) { add_membrane_force_rates(law, lattice, change, rates); }, sheet.fabric);
  add_bending_forces(change, rates);
}

namespace {

// Adds the forces under a given law of fabric.
template <int Dim, FabricLaw Law>
void add_damping_forces_of(const Law& law, const SheetLattice<Dim>& lattice, std::span<const Point<Dim>> velocities,
                           std::span<Point<Dim>> forces) {
  const double beta = lattice.sheet.damping, ds = lattice.sheet.ds, dr = lattice.sheet.dr;
  const auto damp = [&](std::size_t a, std::size_t b, double factor) {
    const Point<Dim> edge = lattice.x[b] - lattice.x[a];
    const Point<Dim> drag = factor * edge.dot(velocities[b] - velocities[a]) * edge;
    forces[a] += drag;
    forces[b] -= drag;
  };
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k))
      damp(k, k + lattice.m, beta * lattice.share_s(k) * law.warp_modulus(lattice.strain_s(k)) * dr / (ds * ds * ds));
    if (lattice.has_edge_r(k))
      damp(k, k + 1, beta * lattice.share_r(k) * law.weft_modulus(lattice.strain_r(k)) * ds / (dr * dr * dr));
  }
}

}  // namespace

template <int Dim>
void add_damping_forces(const Sheet& sheet, std::span<const Point<Dim>> positions,
                        std::span<const Point<Dim>> velocities, std::span<Point<Dim>> forces) {
  const SheetLattice<Dim> lattice(sheet, positions);
  std::visit([&](const auto& law) { add_damping_forces_of(law, lattice, velocities, forces); }, sheet.fabric);
}

template <int Dim>
double elastic_energy(const Sheet& sheet, std::span<const Point<Dim>> positions, std::size_t first, std::size_t last) {
  const SheetLattice<Dim> lattice(sheet, positions);
  return std::visit([&](const auto& law) { return elastic_energy_of(law, lattice, first, last); }, sheet.fabric);
}

double largest_stiffness(const Sheet& sheet) {
  const LargestModuli membrane = largest_moduli_of(sheet.fabric);
  const BendingModuli bending = bending_of(sheet.fabric);
  const double per_s = 1 / (sheet.ds * sheet.ds), per_r = 1 / (sheet.dr * sheet.dr);
  const double bending_s = 4 * bending.s * per_s * per_s;
  if (sheet.width == 1) return membrane.s * per_s + bending_s;
  const double along_s = (1 + membrane.poisson) * membrane.s * per_s + membrane.shear * per_r;
  const double along_r = (1 + membrane.poisson) * membrane.r * per_r + membrane.shear * per_s;
  const double mixed = 8 * (std::abs(bending.cross) + bending.twist) * per_s * per_r;
  return std::max(along_s, along_r) + bending_s + 4 * bending.r * per_r * per_r + mixed;
}

double cancelling_size(const Sheet& sheet, double distance) {
  const LargestModuli membrane = largest_moduli_of(sheet.fabric);
  const BendingModuli bending = bending_of(sheet.fabric);
  const double ds = sheet.ds, dr = sheet.dr;
  double size = membrane.s * dr + 16 * bending.s * dr * distance / std::pow(ds, 3);
  if (sheet.width > 1) size += membrane.r * ds + 16 * bending.r * ds * distance / std::pow(dr, 3);
  return size;
}

template void add_energy_forces<2>(const Sheet&, std::span<const Point<2>>, std::span<Point<2>>);
template void add_energy_forces<3>(const Sheet&, std::span<const Point<3>>, std::span<Point<3>>);
template void add_energy_force_rates<2>(const Sheet&, std::span<const Point<2>>, std::span<const Point<2>>,
                                        std::span<Point<2>>);
template void add_energy_force_rates<3>(const Sheet&, std::span<const Point<3>>, std::span<const Point<3>>,
                                        std::span<Point<3>>);
template void add_damping_forces<2>(const Sheet&, std::span<const Point<2>>, std::span<const Point<2>>,
                                    std::span<Point<2>>);
template void add_damping_forces<3>(const Sheet&, std::span<const Point<3>>, std::span<const Point<3>>,
                                    std::span<Point<3>>);
template double elastic_energy<2>(const Sheet&, std::span<const Point<2>>, std::size_t, std::size_t);
template double elastic_energy<3>(const Sheet&, std::span<const Point<3>>, std::size_t, std::size_t);

}  // namespace washfsi
