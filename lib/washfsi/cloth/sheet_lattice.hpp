// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "washfsi/cloth/sheet.hpp"

// What forces, stiffness and states of a sheet share: its edges, quads and bends, strains, resultants and moments.

namespace washfsi {

/// Positions as a lattice of rows: the edges, quads and bends that they form.
template <int Dim>
class SheetLattice {
 public:
  SheetLattice(const Sheet& of_sheet, std::span<const Point<Dim>> positions)
      : sheet(of_sheet), x(positions), m(std::max<std::size_t>(sheet.width, 1)), n(positions.size() / m) {}

  const Sheet& sheet;
  std::span<const Point<Dim>> x;
  const std::size_t m, n;  ///< markers along r, rows

  bool has_edge_s(std::size_t k) const { return k / m + 1 < n; }
  bool has_edge_r(std::size_t k) const { return k % m + 1 < m; }
  bool has_quad(std::size_t k) const { return has_edge_s(k) && has_edge_r(k); }
  bool bends_along_s(std::size_t k) const { return k >= m && has_edge_s(k); }
  bool bends_along_r(std::size_t k) const { return k % m > 0 && has_edge_r(k); }
  Point<Dim> edge_s(std::size_t k) const { return x[k + m] - x[k]; }
  Point<Dim> edge_r(std::size_t k) const { return x[k + 1] - x[k]; }
  /// Mean tangents X_s and X_r of a quad.
  Point<Dim> tangent_s(std::size_t k) const { return 0.5 / sheet.ds * (edge_s(k) + edge_s(k + 1)); }
  Point<Dim> tangent_r(std::size_t k) const { return 0.5 / sheet.dr * (edge_r(k) + edge_r(k + m)); }
  Point<Dim> second_difference_s(std::size_t k) const {
    return (x[k + m] - 2 * x[k] + x[k - m]) / (sheet.ds * sheet.ds);
  }
  Point<Dim> second_difference_r(std::size_t k) const {
    return (x[k + 1] - 2 * x[k] + x[k - 1]) / (sheet.dr * sheet.dr);
  }
  Point<Dim> mixed_difference(std::size_t k) const { return (edge_s(k + 1) - edge_s(k)) / (sheet.ds * sheet.dr); }
  /// w: of an edge along s with this many sides without a quad.
  double edge_weight_s(std::size_t k) const { return edge_weight(k % m == 0, k % m + 1 == m); }
  double edge_weight_r(std::size_t k) const { return edge_weight(k < m, k / m + 1 == n); }
  /// f
  double bend_weight(std::size_t k) const {
    return bends_along_s(k) && bends_along_r(k) ? 1 : 1 - sheet.poisson * sheet.poisson;
  }
  /// g_i g_j
  double twist_weight(std::size_t k) const {
    const double along_s = 1 + 0.5 * (k < m) + 0.5 * (k / m + 2 == n);
    const double along_r = 1 + 0.5 * (k % m == 0) + 0.5 * (k % m + 2 == m);
    return along_s * along_r;
  }

 private:
  double edge_weight(bool first_is_bare, bool last_is_bare) const {
    return 1 - 0.5 * sheet.poisson * sheet.poisson * (first_is_bare + last_is_bare);
  }
};

/// One value per edge along s, edge along r and quad, under the number of its lowest marker: the strains E11, E22 and
/// 2 E12 = a.b, or the resultants N11, N22 and N12.
struct Membrane {
  std::vector<double> s, r, shear;
  explicit Membrane(std::size_t markers) : s(markers, 0.0), r(markers, 0.0), shear(markers, 0.0) {}
};

template <int Dim>
Membrane strains_of(const SheetLattice<Dim>& lattice) {
  Membrane strains(lattice.x.size());
  const double ds2 = lattice.sheet.ds * lattice.sheet.ds, dr2 = lattice.sheet.dr * lattice.sheet.dr;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k)) strains.s[k] = 0.5 * (lattice.edge_s(k).squaredNorm() / ds2 - 1);
    if (lattice.has_edge_r(k)) strains.r[k] = 0.5 * (lattice.edge_r(k).squaredNorm() / dr2 - 1);
    if (lattice.has_quad(k)) strains.shear[k] = lattice.tangent_s(k).dot(lattice.tangent_r(k));
  }
  return strains;
}

inline double cross_extension(const Sheet& sheet) {
  return sheet.poisson * std::sqrt(sheet.ke_s * sheet.ke_r);
}
inline double cross_bending(const Sheet& sheet) {
  return sheet.poisson * std::sqrt(sheet.kb_s * sheet.kb_r);
}

// dE/dE11, dE/dE22 and dE/d(2 E12) per area ds dr.
template <int Dim>
Membrane resultants_of(const SheetLattice<Dim>& lattice, const Membrane& strains) {
  const Sheet& sheet = lattice.sheet;
  const std::size_t m = lattice.m;
  const double cross = cross_extension(sheet);
  Membrane result(lattice.x.size());
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    result.s[k] += lattice.edge_weight_s(k) * sheet.ke_s * strains.s[k];
    result.r[k] += lattice.edge_weight_r(k) * sheet.ke_r * strains.r[k];
    result.shear[k] = sheet.ks * strains.shear[k];
    if (cross == 0 || !lattice.has_quad(k)) continue;
    const double from_s = 0.25 * cross * (strains.s[k] + strains.s[k + 1]);
    const double from_r = 0.25 * cross * (strains.r[k] + strains.r[k + m]);
    result.s[k] += from_r;
    result.s[k + 1] += from_r;
    result.r[k] += from_s;
    result.r[k + m] += from_s;
  }
  return result;
}

/// Moments at a marker as vectors: M11 e3 and M22 e3 where the cloth is smooth.
template <int Dim>
struct Moments {
  Point<Dim> s = Point<Dim>::Zero(), r = Point<Dim>::Zero();

  Moments(const SheetLattice<Dim>& lattice, std::size_t k) {
    const Sheet& sheet = lattice.sheet;
    const bool along_s = lattice.bends_along_s(k), along_r = lattice.bends_along_r(k);
    const double weight = lattice.bend_weight(k);
    if (along_s) s = weight * sheet.kb_s * lattice.second_difference_s(k);
    if (along_r) r = weight * sheet.kb_r * lattice.second_difference_r(k);
    if (!along_s || !along_r) return;
    const double cross = cross_bending(sheet);
    s += cross * lattice.second_difference_r(k);
    r += cross * lattice.second_difference_s(k);
  }
};

}  // namespace washfsi
