// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/sheet_lattice.hpp"

namespace washfsi {

namespace {

/// The stiffness of a few markers that belong together, summed up before it is handed on: adding to a large sparse
/// matrix costs more than all else.
template <int Dim, std::size_t Count>
class ElementStiffness {
 public:
  explicit ElementStiffness(const std::array<std::size_t, Count>& markers) : markers_(markers) {
    for (auto& row : blocks_) row.fill(StiffnessBlock<Dim>::Zero());
  }
  /// factor a b^T
  void add(double factor, const std::array<Point<Dim>, Count>& a, const std::array<Point<Dim>, Count>& b) {
    for (std::size_t p = 0; p < Count; ++p)
      for (std::size_t q = 0; q < Count; ++q) {
        blocks_[p][q] += factor * a[p] * b[q].transpose();
        is_used_[p][q] = true;
      }
  }
  /// factor a b^T of numbers, each times the identity
  void add(double factor, const std::array<double, Count>& a, const std::array<double, Count>& b) {
    for (std::size_t p = 0; p < Count; ++p)
      for (std::size_t q = 0; q < Count; ++q) {
        if (a[p] == 0 || b[q] == 0) continue;
        blocks_[p][q].diagonal().array() += factor * a[p] * b[q];
        is_used_[p][q] = true;
      }
  }
  /// The same blocks in the same order, whatever their values.
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

// Of Poisson's coupling, shear and twist.
template <int Dim>
void add_quad_stiffness(const SheetLattice<Dim>& lattice, std::size_t k, double shear, bool geometric,
                        const AddBlock<Dim>& add) {
  const Sheet& sheet = lattice.sheet;
  const std::size_t m = lattice.m;
  const double area = sheet.marker_area(), half_s = 0.5 / sheet.ds, half_r = 0.5 / sheet.dr;
  ElementStiffness<Dim, 4> element({k, k + 1, k + m, k + m + 1});
  const std::array along_s{-half_s, -half_s, half_s, half_s}, along_r{-half_r, half_r, -half_r, half_r};
  const Point<Dim> a = lattice.tangent_s(k), b = lattice.tangent_r(k);
  std::array<Point<Dim>, 4> of_shear, of_s, of_r;  // gradients of a.b, <E11> and <E22>
  for (std::size_t p = 0; p < 4; ++p) {
    of_shear[p] = along_s[p] * b + along_r[p] * a;
    of_s[p] = along_s[p] / sheet.ds * lattice.edge_s(p % 2 == 0 ? k : k + 1);
    of_r[p] = along_r[p] / sheet.dr * lattice.edge_r(p < 2 ? k : k + m);
  }
  const double cross = area * cross_extension(sheet);
  if (cross != 0) {
    element.add(cross, of_s, of_r);
    element.add(cross, of_r, of_s);
  }
  element.add(area * sheet.ks, of_shear, of_shear);
  if (geometric) {
    element.add(area * shear, along_s, along_r);
    element.add(area * shear, along_r, along_s);
  }
  const double per_quad = 1 / (sheet.ds * sheet.dr);
  const std::array mixed{per_quad, -per_quad, -per_quad, per_quad};
  element.add(2 * area * lattice.twist_weight(k) * sheet.kt, mixed, mixed);
  element.hand_on(add);
}

template <int Dim>
void add_membrane_stiffness(const SheetLattice<Dim>& lattice, GeometricStiffness geometric, const AddBlock<Dim>& add) {
  const Sheet& sheet = lattice.sheet;
  const bool all = geometric == GeometricStiffness::all;
  const Membrane pulls = resultants_of(lattice, strains_of(lattice));
  const auto kept = [&](double pull) { return all ? pull : std::max(pull, 0.0); };
  const double ds = sheet.ds, dr = sheet.dr, along_s = sheet.ke_s * dr / (ds * ds * ds),
               along_r = sheet.ke_r * ds / (dr * dr * dr);
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k))
      add_edge_stiffness<Dim>({k, k + lattice.m}, lattice.edge_s(k), lattice.edge_weight_s(k) * along_s,
                              kept(pulls.s[k]) * dr / ds, add);
    if (lattice.has_edge_r(k))
      add_edge_stiffness<Dim>({k, k + 1}, lattice.edge_r(k), lattice.edge_weight_r(k) * along_r,
                              kept(pulls.r[k]) * ds / dr, add);
    if (lattice.has_quad(k)) add_quad_stiffness<Dim>(lattice, k, pulls.shear[k], all, add);
  }
}

// Bending is linear: its stiffness is the same for every shape.
template <int Dim>
void add_bending_stiffness(const SheetLattice<Dim>& lattice, const AddBlock<Dim>& add) {
  const Sheet& sheet = lattice.sheet;
  const std::size_t m = lattice.m;
  const double area = sheet.marker_area(), per_s = 1 / (sheet.ds * sheet.ds), per_r = 1 / (sheet.dr * sheet.dr);
  const std::array second_s{per_s, 0.0, -2 * per_s, 0.0, per_s}, second_r{0.0, per_r, -2 * per_r, per_r, 0.0};
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    const double weight = area * lattice.bend_weight(k);
    const bool along_s = lattice.bends_along_s(k), along_r = lattice.bends_along_r(k);
    ElementStiffness<Dim, 5> element({k - m, k - 1, k, k + 1, k + m});
    if (along_s) element.add(weight * sheet.kb_s, second_s, second_s);
    if (along_r) element.add(weight * sheet.kb_r, second_r, second_r);
    if (along_s && along_r) {
      element.add(area * cross_bending(sheet), second_s, second_r);
      element.add(area * cross_bending(sheet), second_r, second_s);
    }
    element.hand_on(add);
  }
}

}  // namespace

template <int Dim>
void add_energy_stiffness(const Sheet& sheet, std::span<const Point<Dim>> positions, GeometricStiffness geometric,
                          const AddBlock<Dim>& add) {
  const SheetLattice<Dim> lattice(sheet, positions);
  add_membrane_stiffness(lattice, geometric, add);
  add_bending_stiffness(lattice, add);
}

template void add_energy_stiffness<2>(const Sheet&, std::span<const Point<2>>, GeometricStiffness, const AddBlock<2>&);
template void add_energy_stiffness<3>(const Sheet&, std::span<const Point<3>>, GeometricStiffness, const AddBlock<3>&);

}  // namespace washfsi
