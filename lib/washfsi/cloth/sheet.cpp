// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/sheet_lattice.hpp"

namespace washfsi {

namespace {

// Rates of the strains as the markers move along a direction.
template <int Dim>
Membrane strain_rates_of(const SheetLattice<Dim>& lattice, const SheetLattice<Dim>& direction) {
  Membrane rates(lattice.x.size());
  const double ds2 = lattice.sheet.ds * lattice.sheet.ds, dr2 = lattice.sheet.dr * lattice.sheet.dr;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k)) rates.s[k] = lattice.edge_s(k).dot(direction.edge_s(k)) / ds2;
    if (lattice.has_edge_r(k)) rates.r[k] = lattice.edge_r(k).dot(direction.edge_r(k)) / dr2;
    if (lattice.has_quad(k))
      rates.shear[k] =
          direction.tangent_s(k).dot(lattice.tangent_r(k)) + lattice.tangent_s(k).dot(direction.tangent_r(k));
  }
  return rates;
}

// Forces of resultants along the edges and tangents of a lattice: linear in both.
template <int Dim>
void add_membrane_forces(const SheetLattice<Dim>& lattice, const Membrane& pulls, std::span<Point<Dim>> forces) {
  const double ds = lattice.sheet.ds, dr = lattice.sheet.dr;
  const std::size_t m = lattice.m;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k)) {
      const Point<Dim> pull = pulls.s[k] * dr / ds * lattice.edge_s(k);
      forces[k] += pull;
      forces[k + m] -= pull;
    }
    if (lattice.has_edge_r(k)) {
      const Point<Dim> pull = pulls.r[k] * ds / dr * lattice.edge_r(k);
      forces[k] += pull;
      forces[k + 1] -= pull;
    }
    if (lattice.has_quad(k) && pulls.shear[k] != 0) {
      const Point<Dim> along_r = 0.5 * dr * pulls.shear[k] * lattice.tangent_r(k);
      const Point<Dim> along_s = 0.5 * ds * pulls.shear[k] * lattice.tangent_s(k);
      forces[k] += along_r + along_s;
      forces[k + 1] += along_r - along_s;
      forces[k + m] += along_s - along_r;
      forces[k + m + 1] -= along_r + along_s;
    }
  }
}

template <int Dim>
void add_bending_forces(const SheetLattice<Dim>& lattice, std::span<Point<Dim>> forces) {
  const Sheet& sheet = lattice.sheet;
  const std::size_t m = lattice.m;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const Moments<Dim> moments(lattice, k);
    if (lattice.bends_along_s(k)) {
      const Point<Dim> couple = sheet.dr / sheet.ds * moments.s;
      forces[k - m] -= couple;
      forces[k] += 2 * couple;
      forces[k + m] -= couple;
    }
    if (lattice.bends_along_r(k)) {
      const Point<Dim> couple = sheet.ds / sheet.dr * moments.r;
      forces[k - 1] -= couple;
      forces[k] += 2 * couple;
      forces[k + 1] -= couple;
    }
    if (lattice.has_quad(k)) {
      const Point<Dim> couple = 2 * sheet.kt * lattice.twist_weight(k) * lattice.mixed_difference(k);
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
  add_membrane_forces(lattice, resultants_of(lattice, strain_rates_of(lattice, change)), rates);
  add_membrane_forces(change, resultants_of(lattice, strains_of(lattice)), rates);
  add_bending_forces(change, rates);
}

template <int Dim>
void add_damping_forces(const Sheet& sheet, std::span<const Point<Dim>> positions,
                        std::span<const Point<Dim>> velocities, std::span<Point<Dim>> forces) {
  const SheetLattice<Dim> lattice(sheet, positions);
  const double ds = sheet.ds, dr = sheet.dr;
  const double along_s = sheet.damping * sheet.ke_s * dr / (ds * ds * ds);
  const double along_r = sheet.damping * sheet.ke_r * ds / (dr * dr * dr);
  const auto damp = [&](std::size_t a, std::size_t b, double factor) {
    const Point<Dim> edge = positions[b] - positions[a];
    const Point<Dim> drag = factor * edge.dot(velocities[b] - velocities[a]) * edge;
    forces[a] += drag;
    forces[b] -= drag;
  };
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (lattice.has_edge_s(k)) damp(k, k + lattice.m, along_s);
    if (lattice.has_edge_r(k)) damp(k, k + 1, along_r);
  }
}

template <int Dim>
double elastic_energy(const Sheet& sheet, std::span<const Point<Dim>> positions, std::size_t first, std::size_t last) {
  const SheetLattice<Dim> lattice(sheet, positions);
  const Membrane strains = strains_of(lattice);
  const double cross = cross_extension(sheet), cross_bend = cross_bending(sheet);
  double energy = 0;
  for (std::size_t k = first; k < last; ++k) {
    energy += 0.5 * lattice.edge_weight_s(k) * sheet.ke_s * strains.s[k] * strains.s[k] +
              0.5 * lattice.edge_weight_r(k) * sheet.ke_r * strains.r[k] * strains.r[k];
    const bool along_s = lattice.bends_along_s(k), along_r = lattice.bends_along_r(k);
    const double weight = 0.5 * lattice.bend_weight(k);
    if (along_s) energy += weight * sheet.kb_s * lattice.second_difference_s(k).squaredNorm();
    if (along_r) energy += weight * sheet.kb_r * lattice.second_difference_r(k).squaredNorm();
    if (along_s && along_r) energy += cross_bend * lattice.second_difference_s(k).dot(lattice.second_difference_r(k));
    if (!lattice.has_quad(k)) continue;
    energy += 0.25 * cross * (strains.s[k] + strains.s[k + 1]) * (strains.r[k] + strains.r[k + lattice.m]) +
              0.5 * sheet.ks * strains.shear[k] * strains.shear[k] +
              lattice.twist_weight(k) * sheet.kt * lattice.mixed_difference(k).squaredNorm();
  }
  return sheet.marker_area() * energy;
}

template <int Dim>
double largest_stretch(const Sheet& sheet, std::span<const Point<Dim>> positions) {
  const SheetLattice<Dim> lattice(sheet, positions);
  double most = 0;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (lattice.has_edge_s(k)) most = std::max(most, lattice.edge_s(k).norm() / sheet.ds - 1);
    if (lattice.has_edge_r(k)) most = std::max(most, lattice.edge_r(k).norm() / sheet.dr - 1);
  }
  return most;
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
template double largest_stretch<2>(const Sheet&, std::span<const Point<2>>);
template double largest_stretch<3>(const Sheet&, std::span<const Point<3>>);

}  // namespace washfsi
