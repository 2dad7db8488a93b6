// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "washfsi/cloth/reference_lattice.hpp"

// Common parts of forces, stiffness and states of a sheet: its edges, quads and bends, strains and moments.

namespace washfsi {

/// Positions as a lattice of rows: its edges, tangents, strains and curvatures.
template <int Dim>
class SheetLattice : public ReferenceLattice {
 public:
  SheetLattice(const Sheet& of_sheet, std::span<const Point<Dim>> positions)
      : ReferenceLattice(of_sheet, positions.size()), x(positions) {}

  std::span<const Point<Dim>> x;

  Point<Dim> edge_s(std::size_t k) const { return x[k + m] - x[k]; }
  Point<Dim> edge_r(std::size_t k) const { return x[k + 1] - x[k]; }
  /// E11 and E22 of an edge.
  double strain_s(std::size_t k) const { return 0.5 * (edge_s(k).squaredNorm() / (sheet.ds * sheet.ds) - 1); }
  double strain_r(std::size_t k) const { return 0.5 * (edge_r(k).squaredNorm() / (sheet.dr * sheet.dr) - 1); }
  /// Mean tangents <X_s> and <X_r> of a quad.
  Point<Dim> tangent_s(std::size_t k) const { return 0.5 / sheet.ds * (edge_s(k) + edge_s(k + 1)); }
  Point<Dim> tangent_r(std::size_t k) const { return 0.5 / sheet.dr * (edge_r(k) + edge_r(k + m)); }
  Point<Dim> second_difference_s(std::size_t k) const {
    return (x[k + m] - 2 * x[k] + x[k - m]) / (sheet.ds * sheet.ds);
  }
  Point<Dim> second_difference_r(std::size_t k) const {
    return (x[k + 1] - 2 * x[k] + x[k - 1]) / (sheet.dr * sheet.dr);
  }
  Point<Dim> mixed_difference(std::size_t k) const { return (edge_s(k + 1) - edge_s(k)) / (sheet.ds * sheet.dr); }
};

/// One value per edge along s, edge along r and quad, under the number of its lowest marker: the strains E11, E22 and
/// 2 E12 = <X_s>.<X_r>, or the resultants N11, N22 and N12.
struct Membrane {
  std::vector<double> s, r, shear;
  explicit Membrane(std::size_t markers) : s(markers, 0.0), r(markers, 0.0), shear(markers, 0.0) {}

  /// The values of quad k and of the edges round it, with m markers per row.
  QuadVector quad(std::size_t k, std::size_t m) const { return {s[k], s[k + 1], r[k], r[k + m], shear[k]}; }
};

template <int Dim>
Membrane strains_of(const SheetLattice<Dim>& lattice) {
  Membrane strains(lattice.x.size());
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k)) strains.s[k] = lattice.strain_s(k);
    if (lattice.has_edge_r(k)) strains.r[k] = lattice.strain_r(k);
    if (lattice.has_quad(k)) strains.shear[k] = lattice.tangent_s(k).dot(lattice.tangent_r(k));
  }
  return strains;
}

/// Moments at a marker as vectors: w_b K_b,s X_ss + nu_P sqrt(K_b,s K_b,r) X_rr, and likewise along r, the second term
/// only where both X_ss and X_rr exist. They are M_b,11 n and M_b,22 n where the cloth is smooth.
template <int Dim>
struct Moments {
  Point<Dim> s = Point<Dim>::Zero(), r = Point<Dim>::Zero();

  Moments(const SheetLattice<Dim>& lattice, std::size_t k) {
    const BendingModuli& bending = lattice.bending;
    const bool along_s = lattice.bends_along_s(k), along_r = lattice.bends_along_r(k);
    const double weight = lattice.bend_weight(k);
    if (along_s) s = weight * bending.s * lattice.second_difference_s(k);
    if (along_r) r = weight * bending.r * lattice.second_difference_r(k);
    if (!along_s || !along_r) return;
    s += bending.cross * lattice.second_difference_r(k);
    r += bending.cross * lattice.second_difference_s(k);
  }
};

}  // namespace washfsi
