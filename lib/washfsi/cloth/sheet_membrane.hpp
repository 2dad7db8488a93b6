// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/sheet_lattice.hpp"

// The membrane of a sheet under any law of fabric (cloth/fabric_law.hpp): its resultants, forces and energy.

namespace washfsi {

/// Rates of the strains as the markers move along a direction.
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

/// Sums the resultants from edges and quads: of_s(k) and of_r(k) of edges, of_quad(k) of quads for all edges round
/// them.
template <int Dim, class OfS, class OfR, class OfQuad>
Membrane sum_of_resultants(const SheetLattice<Dim>& lattice, const OfS& of_s, const OfR& of_r, const OfQuad& of_quad) {
  const std::size_t m = lattice.m;
  Membrane result(lattice.x.size());
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k)) result.s[k] += of_s(k);
    if (lattice.has_edge_r(k)) result.r[k] += of_r(k);
    if (!lattice.has_quad(k)) continue;
    const QuadVector quad = of_quad(k);
    result.s[k] += quad[0];
    result.s[k + 1] += quad[1];
    result.r[k] += quad[2];
    result.r[k + m] += quad[3];
    result.shear[k] = quad[4];
  }
  return result;
}

/// dPsi/dE11, dPsi/dE22 and dPsi/d(2 E12) per area ds dr, whatever the edge's own.
template <int Dim, FabricLaw Law>
Membrane resultants_of(const Law& law, const SheetLattice<Dim>& lattice, const Membrane& strains) {
  return sum_of_resultants(
      lattice, [&](std::size_t k) { return lattice.share_s(k) * law.warp(strains.s[k], lattice.bare_s(k)).resultant; },
      [&](std::size_t k) { return lattice.share_r(k) * law.weft(strains.r[k], lattice.bare_r(k)).resultant; },
      [&](std::size_t k) -> QuadVector { return law.quad(strains.quad(k, lattice.m)).resultants(); });
}

/// Rates of these resultants at rates of the strains.
template <int Dim, FabricLaw Law>
Membrane resultant_rates_of(const Law& law, const SheetLattice<Dim>& lattice, const Membrane& strains,
                            const Membrane& rates) {
  return sum_of_resultants(
      lattice,
      [&](std::size_t k) {
        return lattice.share_s(k) * law.warp(strains.s[k], lattice.bare_s(k)).tangent * rates.s[k];
      },
      [&](std::size_t k) {
        return lattice.share_r(k) * law.weft(strains.r[k], lattice.bare_r(k)).tangent * rates.r[k];
      },
      [&](std::size_t k) -> QuadVector {
        return law.quad(strains.quad(k, lattice.m)).tangent() * rates.quad(k, lattice.m);
      });
}

/// Forces of resultants along the edges and tangents of a lattice: linear in both.
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

/// Rates of these forces as the markers move along a direction, which is given as a lattice too.
template <int Dim, FabricLaw Law>
void add_membrane_force_rates(const Law& law, const SheetLattice<Dim>& lattice, const SheetLattice<Dim>& direction,
                              std::span<Point<Dim>> rates) {
  const Membrane strains = strains_of(lattice);
  add_membrane_forces(lattice, resultant_rates_of(law, lattice, strains, strain_rates_of(lattice, direction)), rates);
  add_membrane_forces(direction, resultants_of(law, lattice, strains), rates);
}

/// The energy of `elastic_energy` under a given law, bending included.
template <int Dim, FabricLaw Law>
double elastic_energy_of(const Law& law, const SheetLattice<Dim>& lattice, std::size_t first, std::size_t last) {
  const Membrane strains = strains_of(lattice);
  const BendingModuli& bending = lattice.bending;
  double energy = 0;
  for (std::size_t k = first; k < last; ++k) {
    energy += lattice.share_s(k) * law.warp(strains.s[k], lattice.bare_s(k)).energy +
              lattice.share_r(k) * law.weft(strains.r[k], lattice.bare_r(k)).energy;
    const bool along_s = lattice.bends_along_s(k), along_r = lattice.bends_along_r(k);
    const double weight = 0.5 * lattice.share(k) * lattice.bend_weight(k);
    if (along_s) energy += weight * bending.s * lattice.second_difference_s(k).squaredNorm();
    if (along_r) energy += weight * bending.r * lattice.second_difference_r(k).squaredNorm();
    if (along_s && along_r)
      energy += bending.cross * lattice.second_difference_s(k).dot(lattice.second_difference_r(k));
    if (lattice.has_quad(k))
      energy += law.quad(strains.quad(k, lattice.m)).energy() +
                lattice.twist_weight(k) * bending.twist * lattice.mixed_difference(k).squaredNorm();
  }
  return lattice.sheet.part_area() * energy;
}

/// The energy as above under the law of the sheet.
template <int Dim>
Membrane resultants_of(const SheetLattice<Dim>& lattice, const Membrane& strains) {
  return std::visit([&](const auto& law) { return resultants_of(law, lattice, strains); }, lattice.sheet.fabric);
}

}  // namespace washfsi
