// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/sheet_membrane.hpp"

// The stiffness of a sheet's edges and quads under any law of fabric (cloth/fabric_law.hpp).

namespace washfsi {

/// The stiffness of a few neighbouring markers, summed up before it is handed on: adding to a large sparse matrix costs
/// more than all else.
template <int Dim, std::size_t Count>
class ElementStiffness {
 public:
  explicit ElementStiffness(const std::array<std::size_t, Count>& markers) : markers_(markers) {
    for (auto& row : blocks_) row.fill(StiffnessBlock<Dim>::Zero());
  }
  /// Adds to the block of two of the markers.
  template <class Block>
  void add(std::size_t p, std::size_t q, const Eigen::MatrixBase<Block>& block) {
    blocks_[p][q] += block;
    is_used_[p][q] = true;
  }
  /// Adds factor a b^T.
  void add(double factor, const std::array<Point<Dim>, Count>& a, const std::array<Point<Dim>, Count>& b) {
    for (std::size_t p = 0; p < Count; ++p)
      for (std::size_t q = 0; q < Count; ++q) add(p, q, factor * a[p] * b[q].transpose());
  }
  /// Adds factor a b^T of numbers, each times the identity.
  void add(double factor, const std::array<double, Count>& a, const std::array<double, Count>& b) {
    for (std::size_t p = 0; p < Count; ++p)
      for (std::size_t q = 0; q < Count; ++q) {
        if (a[p] == 0 || b[q] == 0) continue;
        blocks_[p][q].diagonal().array() += factor * a[p] * b[q];
        is_used_[p][q] = true;
      }
  }
  /// Calls `add` for the blocks, always the same ones in the same order, whatever their values.
  void hand_on(const AddBlock<Dim>& add) const {
    for (std::size_t p = 0; p < Count; ++p)
      for (std::size_t q = 0; q < Count; ++q)
        if (is_used_[p][q]) add(markers_[p], markers_[q], blocks_[p][q]);
  }

 private:
  std::array<std::size_t, Count> markers_;
  std::array<std::array<StiffnessBlock<Dim>, Count>, Count> blocks_;
  std::array<std::array<bool, Count>, Count> is_used_{};
};

template <int Dim>
void add_edge_stiffness(const std::array<std::size_t, 2>& markers, const Point<Dim>& edge, double material,
                        double geometric, const AddBlock<Dim>& add) {
  const StiffnessBlock<Dim> block = material * edge * edge.transpose() + geometric * StiffnessBlock<Dim>::Identity();
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t q = 0; q < 2; ++q) add(markers[p], markers[q], p == q ? block : StiffnessBlock<Dim>(-block));
}

/// Gradients of a quad's strains with respect to its markers k, k + 1, k + m and k + m + 1. Each marker is an end of
/// one of its two edges along s and of one of those along r.
template <int Dim>
struct QuadGradients {
  std::array<double, 4> along_s, along_r;  ///< gradients of the mean tangents: times the identity
  std::array<Point<Dim>, 4> s, r, shear;   ///< gradients of E11 and E22 of the marker's edges and of 2 E12

  QuadGradients(const SheetLattice<Dim>& lattice, std::size_t k) {
    const double ds = lattice.sheet.ds, dr = lattice.sheet.dr, half_s = 0.5 / ds, half_r = 0.5 / dr;
    along_s = {-half_s, -half_s, half_s, half_s};
    along_r = {-half_r, half_r, -half_r, half_r};
    const Point<Dim> a = lattice.tangent_s(k), b = lattice.tangent_r(k);
    for (std::size_t p = 0; p < 4; ++p) {
      s[p] = 2 * along_s[p] / ds * lattice.edge_s(p % 2 == 0 ? k : k + 1);
      r[p] = 2 * along_r[p] / dr * lattice.edge_r(p < 2 ? k : k + lattice.m);
      shear[p] = along_s[p] * b + along_r[p] * a;
    }
  }
};

/// Adds G^T tangent G times an area.
template <int Dim>
void add_material(ElementStiffness<Dim, 4>& element, const MeanTangent& tangent, double area,
                  const QuadGradients<Dim>& gradients) {
  if (tangent.coupling != 0) {
    element.add(0.25 * area * tangent.coupling, gradients.s, gradients.r);
    element.add(0.25 * area * tangent.coupling, gradients.r, gradients.s);
  }
  element.add(area * tangent.shear, gradients.shear, gradients.shear);
}

template <int Dim>
void add_material(ElementStiffness<Dim, 4>& element, const QuadMatrix& tangent, double area,
                  const QuadGradients<Dim>& gradients) {
  std::array<Eigen::Matrix<double, Dim, 3>, 4> at;
  for (std::size_t p = 0; p < 4; ++p) at[p] << gradients.s[p], gradients.r[p], gradients.shear[p];
  for (int p = 0; p < 4; ++p)
    for (int q = 0; q < 4; ++q) {
      const Eigen::Matrix3d part = tangent(strains_at_corner(p), strains_at_corner(q));
      const auto row = static_cast<std::size_t>(p), column = static_cast<std::size_t>(q);
      element.add(row, column, area * at[row] * part * at[column].transpose());
    }
}

/// Adds the stiffness of a quad: of its strains, with the tangent of its law, and of twist.
template <int Dim, class Tangent>
void add_quad_stiffness(const SheetLattice<Dim>& lattice, std::size_t k, const Tangent& tangent, double shear,
                        bool geometric, const AddBlock<Dim>& add) {
  const Sheet& sheet = lattice.sheet;
  const double area = sheet.part_area();
  const QuadGradients<Dim> gradients(lattice, k);
  ElementStiffness<Dim, 4> element({k, k + 1, k + lattice.m, k + lattice.m + 1});
  add_material(element, tangent, area, gradients);
  if (geometric) {
    element.add(area * shear, gradients.along_s, gradients.along_r);
    element.add(area * shear, gradients.along_r, gradients.along_s);
  }
  const double per_quad = 1 / (sheet.ds * sheet.dr);
  const std::array mixed{per_quad, -per_quad, -per_quad, per_quad};
  element.add(2 * area * lattice.twist_weight(k) * lattice.bending.twist, mixed, mixed);
  element.hand_on(add);
}

/// Adds the part of `add_energy_stiffness` that stems from edges and quads.
template <int Dim, FabricLaw Law>
void add_membrane_stiffness(const Law& law, const SheetLattice<Dim>& lattice, GeometricStiffness geometric,
                            const AddBlock<Dim>& add) {
  const bool all = geometric == GeometricStiffness::all;
  const Membrane strains = strains_of(lattice), pulls = resultants_of(law, lattice, strains);
  const auto kept = [&](double pull) { return all ? pull : std::max(pull, 0.0); };
  const double ds = lattice.sheet.ds, dr = lattice.sheet.dr;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k))
      add_edge_stiffness<Dim>(
          {k, k + lattice.m}, lattice.edge_s(k),
          lattice.share_s(k) * law.warp(strains.s[k], lattice.bare_s(k)).tangent * dr / (ds * ds * ds),
          kept(pulls.s[k]) * dr / ds, add);
    if (lattice.has_edge_r(k))
      add_edge_stiffness<Dim>(
          {k, k + 1}, lattice.edge_r(k),
          lattice.share_r(k) * law.weft(strains.r[k], lattice.bare_r(k)).tangent * ds / (dr * dr * dr),
          kept(pulls.r[k]) * ds / dr, add);
    if (lattice.has_quad(k))
      add_quad_stiffness<Dim>(lattice, k, law.quad(strains.quad(k, lattice.m)).tangent(), pulls.shear[k], all, add);
  }
}

}  // namespace washfsi
