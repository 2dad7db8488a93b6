// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/sheet.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

/// Positions as a lattice of rows: the edges, quads and bends that they form.
template <int Dim>
class Lattice {
 public:
  Lattice(const Sheet& of_sheet, std::span<const Point<Dim>> positions)
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
Membrane strains_of(const Lattice<Dim>& lattice) {
  Membrane strains(lattice.x.size());
  const double ds2 = lattice.sheet.ds * lattice.sheet.ds, dr2 = lattice.sheet.dr * lattice.sheet.dr;
  for (std::size_t k = 0; k < lattice.x.size(); ++k) {
    if (lattice.has_edge_s(k)) strains.s[k] = 0.5 * (lattice.edge_s(k).squaredNorm() / ds2 - 1);
    if (lattice.has_edge_r(k)) strains.r[k] = 0.5 * (lattice.edge_r(k).squaredNorm() / dr2 - 1);
    if (lattice.has_quad(k)) strains.shear[k] = lattice.tangent_s(k).dot(lattice.tangent_r(k));
  }
  return strains;
}

// Rates of the strains as the markers move along a direction.
template <int Dim>
Membrane strain_rates_of(const Lattice<Dim>& lattice, const Lattice<Dim>& direction) {
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

double cross_extension(const Sheet& sheet) {
  return sheet.poisson * std::sqrt(sheet.ke_s * sheet.ke_r);
}
double cross_bending(const Sheet& sheet) {
  return sheet.poisson * std::sqrt(sheet.kb_s * sheet.kb_r);
}

// dE/dE11, dE/dE22 and dE/d(2 E12) per area ds dr.
template <int Dim>
Membrane resultants_of(const Lattice<Dim>& lattice, const Membrane& strains) {
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

// Forces of resultants along the edges and tangents of a lattice: linear in both.
template <int Dim>
void add_membrane_forces(const Lattice<Dim>& lattice, const Membrane& pulls, std::span<Point<Dim>> forces) {
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

/// Moments at a marker as vectors: M11 e3 and M22 e3 where the cloth is smooth.
template <int Dim>
struct Moments {
  Point<Dim> s = Point<Dim>::Zero(), r = Point<Dim>::Zero();

  Moments(const Lattice<Dim>& lattice, std::size_t k) {
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

template <int Dim>
void add_bending_forces(const Lattice<Dim>& lattice, std::span<Point<Dim>> forces) {
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
      for (std::size_t q = 0; q < Count; ++q) blocks_[p][q] += factor * a[p] * b[q].transpose();
  }
  /// factor a b^T of numbers, each times the identity
  void add(double factor, const std::array<double, Count>& a, const std::array<double, Count>& b) {
    for (std::size_t p = 0; p < Count; ++p)
      for (std::size_t q = 0; q < Count; ++q) blocks_[p][q].diagonal().array() += factor * a[p] * b[q];
  }
  void hand_on(const AddBlock<Dim>& add) const {
    for (std::size_t p = 0; p < Count; ++p)
      for (std::size_t q = 0; q < Count; ++q)
        if (blocks_[p][q] != StiffnessBlock<Dim>::Zero()) add(markers_[p], markers_[q], blocks_[p][q]);
  }

 private:
  std::array<std::size_t, Count> markers_;
  std::array<std::array<StiffnessBlock<Dim>, Count>, Count> blocks_;
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
void add_quad_stiffness(const Lattice<Dim>& lattice, std::size_t k, double shear, bool geometric,
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
void add_membrane_stiffness(const Lattice<Dim>& lattice, GeometricStiffness geometric, const AddBlock<Dim>& add) {
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
void add_bending_stiffness(const Lattice<Dim>& lattice, const AddBlock<Dim>& add) {
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
void add_energy_forces(const Sheet& sheet, std::span<const Point<Dim>> positions, std::span<Point<Dim>> forces) {
  const Lattice<Dim> lattice(sheet, positions);
  add_membrane_forces(lattice, resultants_of(lattice, strains_of(lattice)), forces);
  add_bending_forces(lattice, forces);
}

template <int Dim>
void add_energy_force_rates(const Sheet& sheet, std::span<const Point<Dim>> positions,
                            std::span<const Point<Dim>> direction, std::span<Point<Dim>> rates) {
  const Lattice<Dim> lattice(sheet, positions), change(sheet, direction);
  add_membrane_forces(lattice, resultants_of(lattice, strain_rates_of(lattice, change)), rates);
  add_membrane_forces(change, resultants_of(lattice, strains_of(lattice)), rates);
  add_bending_forces(change, rates);
}

template <int Dim>
void add_energy_stiffness(const Sheet& sheet, std::span<const Point<Dim>> positions, GeometricStiffness geometric,
                          const AddBlock<Dim>& add) {
  const Lattice<Dim> lattice(sheet, positions);
  add_membrane_stiffness(lattice, geometric, add);
  add_bending_stiffness(lattice, add);
}

template <int Dim>
void add_damping_forces(const Sheet& sheet, std::span<const Point<Dim>> positions,
                        std::span<const Point<Dim>> velocities, std::span<Point<Dim>> forces) {
  const Lattice<Dim> lattice(sheet, positions);
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
  const Lattice<Dim> lattice(sheet, positions);
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
  const Lattice<Dim> lattice(sheet, positions);
  double most = 0;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (lattice.has_edge_s(k)) most = std::max(most, lattice.edge_s(k).norm() / sheet.ds - 1);
    if (lattice.has_edge_r(k)) most = std::max(most, lattice.edge_r(k).norm() / sheet.dr - 1);
  }
  return most;
}

namespace {

// Tangents at a marker, between its neighbours as far as it has any.
template <int Dim>
Point<Dim> tangent_between(std::span<const Point<Dim>> x, std::size_t before, std::size_t after) {
  const Point<Dim> along = x[after] - x[before];
  const double length = along.norm();
  return length > 0 ? Point<Dim>(along / length) : Point<Dim>::Zero();
}

}  // namespace

template <int Dim>
Points<Dim> normals(const Sheet& sheet, std::span<const Point<Dim>> positions) {
  const Lattice<Dim> lattice(sheet, positions);
  Points<Dim> result;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Point<Dim> s =
        tangent_between<Dim>(positions, k >= lattice.m ? k - lattice.m : k, lattice.has_edge_s(k) ? k + lattice.m : k);
    if constexpr (Dim == 2) {
      result.emplace_back(-s[1], s[0]);
    } else {
      const Point<Dim> r =
          tangent_between<Dim>(positions, k % lattice.m > 0 ? k - 1 : k, lattice.has_edge_r(k) ? k + 1 : k);
      const Point<Dim> normal = s.cross(r);
      result.push_back(normal.norm() > 0 ? Point<Dim>(normal.normalized()) : Point<Dim>::Zero());
    }
  }
  return result;
}

namespace {

/// Sum over the edges or quads beside a marker that exist, and their number.
struct Beside {
  double sum = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0; }
};

template <int Dim>
MarkerState marker_state(const Lattice<Dim>& lattice, const Membrane& pulls, std::size_t k) {
  const Sheet& sheet = lattice.sheet;
  const std::size_t m = lattice.m;
  const double q = sheet.thickness, per_section = 6 / (q * q);
  Beside pull_s, pull_r, pull_shear, stretch, angle;
  Point<Dim> twist = Point<Dim>::Zero();
  const auto see_s = [&](std::size_t e) {
    pull_s.add(pulls.s[e]);
    stretch.add(std::abs(lattice.edge_s(e).norm() / sheet.ds - 1));
  };
  const auto see_r = [&](std::size_t e) {
    pull_r.add(pulls.r[e]);
    stretch.add(std::abs(lattice.edge_r(e).norm() / sheet.dr - 1));
  };
  const auto see_quad = [&](std::size_t e) {
    const Point<Dim> a = lattice.tangent_s(e), b = lattice.tangent_r(e);
    pull_shear.add(pulls.shear[e]);
    angle.add(std::abs(std::asin(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0))));
    twist += lattice.mixed_difference(e);
  };
  const bool has_before_s = k >= m, has_before_r = k % m > 0;
  if (has_before_s) see_s(k - m);
  if (lattice.has_edge_s(k)) see_s(k);
  if (has_before_r) see_r(k - 1);
  if (lattice.has_edge_r(k)) see_r(k);
  if (has_before_s && has_before_r) see_quad(k - m - 1);
  if (has_before_s && lattice.has_edge_r(k)) see_quad(k - m);
  if (has_before_r && lattice.has_edge_s(k)) see_quad(k - 1);
  if (lattice.has_quad(k)) see_quad(k);
  if (angle.count > 0) twist /= angle.count;

  MarkerState state;
  // the resultants vanish at the free edges, half a spacing beyond the outermost markers
  state.membrane_stress = {0.5 * std::abs(pull_s.sum) / q, 0.5 * std::abs(pull_r.sum) / q,
                           0.25 * std::abs(pull_shear.sum) / q};
  const Moments<Dim> moments(lattice, k);
  state.bending_stress = {per_section * moments.s.norm(), per_section * moments.r.norm(),
                          per_section * sheet.kt * twist.norm()};
  state.stretch = 0.5 * stretch.sum / (m > 1 ? 2 : 1);
  double squares = 2 * twist.squaredNorm();
  if (lattice.bends_along_s(k)) squares += lattice.second_difference_s(k).squaredNorm();
  if (lattice.bends_along_r(k)) squares += lattice.second_difference_r(k).squaredNorm();
  state.curvature = std::sqrt(squares);
  state.shear_angle = angle.mean();
  return state;
}

}  // namespace

double surface_stress(const MarkerState& state) {
  return std::max(state.membrane_stress[ss] + state.bending_stress[ss],
                  state.membrane_stress[rr] + state.bending_stress[rr]);
}

template <int Dim>
std::vector<MarkerState> marker_states(const Sheet& sheet, std::span<const Point<Dim>> positions) {
  const Lattice<Dim> lattice(sheet, positions);
  const Membrane pulls = resultants_of(lattice, strains_of(lattice));
  std::vector<MarkerState> result;
  for (std::size_t k = 0; k < positions.size(); ++k) result.push_back(marker_state(lattice, pulls, k));
  return result;
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
template void add_energy_stiffness<2>(const Sheet&, std::span<const Point<2>>, GeometricStiffness, const AddBlock<2>&);
template void add_energy_stiffness<3>(const Sheet&, std::span<const Point<3>>, GeometricStiffness, const AddBlock<3>&);
template double elastic_energy<2>(const Sheet&, std::span<const Point<2>>, std::size_t, std::size_t);
template double elastic_energy<3>(const Sheet&, std::span<const Point<3>>, std::size_t, std::size_t);
template double largest_stretch<2>(const Sheet&, std::span<const Point<2>>);
template double largest_stretch<3>(const Sheet&, std::span<const Point<3>>);
template Points<2> normals<2>(const Sheet&, std::span<const Point<2>>);
template Points<3> normals<3>(const Sheet&, std::span<const Point<3>>);
template std::vector<MarkerState> marker_states<2>(const Sheet&, std::span<const Point<2>>);
template std::vector<MarkerState> marker_states<3>(const Sheet&, std::span<const Point<3>>);

}  // namespace washfsi
