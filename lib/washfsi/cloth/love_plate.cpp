// SPDX-License-Identifier: BSD-3-Clause
//
// The thesis's strong form of a plate on its own lattice (Figs. 3.4-2, 3.4-3): N11 and N22 at the points between
// neighbours along s and r, N12 at the centroids of four markers, curvature, twist and moments M_b at the markers.
#include "washfsi/cloth/love.hpp"

namespace washfsi {

namespace {

/// Finds the terms of the equations of motion on a lattice of n rows of m markers; indices may lie one outside.
class Plate {
 public:
  Plate(const Sheet& sheet, std::span<const Point<3>> positions)
      : sheet_(sheet),
        moduli_(std::get<LinearFabric>(sheet.fabric).moduli()),
        x_(positions),
        n_(static_cast<long>(positions.size() / sheet.width)),
        m_(static_cast<long>(sheet.width)) {
    for (long i = 0; i < n_; ++i)
      for (long j = 0; j < m_; ++j) find_moments(i, j);
    for (long i = 0; i < n_; ++i)
      for (long j = 0; j < m_; ++j) vanish_at_edges(i, j);
  }

  /// N11 X_s + N12 X_r + Q1 |X_r| n between (i, j) and (i + 1, j); zero beyond the edges.
  Point<3> flux_s(long i, long j) const {
    if (i < 0 || i + 1 >= n_) return Point<3>::Zero();
    const Point<3> a = slope_s(i, j), b = 0.5 * (tangent_r(i, j) + tangent_r(i + 1, j));
    Point<3> flux = moduli_.ke_s * (strain_s(i, j) + moduli_.poisson * beside_s(i, j)) * a;
    for (const long quad : {j - 1, j}) flux += 0.5 * shear(i, quad) * quad_tangent_r(i, quad);
    const double q1 = -(at(m11_, i + 1, j) - at(m11_, i, j)) / (sheet_.ds * a.norm()) -
                      0.5 * (slope_of_m12_r(i, j) + slope_of_m12_r(i + 1, j)) / (sheet_.dr * b.norm());
    return flux + q1 * b.norm() * a.cross(b).normalized();
  }
  /// N12 X_s + N22 X_r + Q2 |X_s| n between (i, j) and (i, j + 1).
  Point<3> flux_r(long i, long j) const {
    if (j < 0 || j + 1 >= m_) return Point<3>::Zero();
    const Point<3> a = 0.5 * (tangent_s(i, j) + tangent_s(i, j + 1)), b = slope_r(i, j);
    Point<3> flux = moduli_.ke_r * (strain_r(i, j) + moduli_.poisson * beside_r(i, j)) * b;
    for (const long quad : {i - 1, i}) flux += 0.5 * shear(quad, j) * quad_tangent_s(quad, j);
    const double q2 = -(at(m22_, i, j + 1) - at(m22_, i, j)) / (sheet_.dr * b.norm()) -
                      0.5 * (slope_of_m12_s(i, j) + slope_of_m12_s(i, j + 1)) / (sheet_.ds * a.norm());
    return flux + q2 * a.norm() * a.cross(b).normalized();
  }

 private:
  std::size_t number(long i, long j) const { return static_cast<std::size_t>(i * m_ + j); }
  double at(const std::vector<double>& values, long i, long j) const { return values[number(i, j)]; }
  const Point<3>& x(long i, long j) const { return x_[number(i, j)]; }
  Point<3> slope_s(long i, long j) const { return (x(i + 1, j) - x(i, j)) / sheet_.ds; }
  Point<3> slope_r(long i, long j) const { return (x(i, j + 1) - x(i, j)) / sheet_.dr; }
  double strain_s(long i, long j) const { return 0.5 * (slope_s(i, j).squaredNorm() - 1); }
  double strain_r(long i, long j) const { return 0.5 * (slope_r(i, j).squaredNorm() - 1); }

  // Tangents at markers; at an edge that of the outermost interval: no moment, no change of slope.
  Point<3> tangent_s(long i, long j) const {
    return 0.5 * (slope_s(std::max(i - 1, 0L), j) + slope_s(std::min(i, n_ - 2), j));
  }
  Point<3> tangent_r(long i, long j) const {
    return 0.5 * (slope_r(i, std::max(j - 1, 0L)) + slope_r(i, std::min(j, m_ - 2)));
  }
  Point<3> quad_tangent_s(long i, long j) const {
    return inside(i, j) ? Point<3>(0.5 * (slope_s(i, j) + slope_s(i, j + 1))) : Point<3>::Zero();
  }
  Point<3> quad_tangent_r(long i, long j) const {
    return inside(i, j) ? Point<3>(0.5 * (slope_r(i, j) + slope_r(i + 1, j))) : Point<3>::Zero();
  }
  bool inside(long i, long j) const { return i >= 0 && i + 1 < n_ && j >= 0 && j + 1 < m_; }
  /// N12 at the centroid of a quad; none beyond the edges.
  double shear(long i, long j) const { return moduli_.ks * quad_tangent_s(i, j).dot(quad_tangent_r(i, j)); }
  /// The other strain at the point of E11 or E22: the mean of those around it.
  double beside_s(long i, long j) const {
    const long below = std::max(j - 1, 0L), above = std::min(j, m_ - 2);
    return 0.25 * (strain_r(i, below) + strain_r(i, above) + strain_r(i + 1, below) + strain_r(i + 1, above));
  }
  double beside_r(long i, long j) const {
    const long below = std::max(i - 1, 0L), above = std::min(i, n_ - 2);
    return 0.25 * (strain_s(below, j) + strain_s(above, j) + strain_s(below, j + 1) + strain_s(above, j + 1));
  }

  void find_moments(long i, long j) {
    const Point<3> a = tangent_s(i, j), b = tangent_r(i, j), normal = a.cross(b).normalized();
    const Point<3> bend_s = (slope_s(std::min(i, n_ - 2), j) - slope_s(std::max(i - 1, 0L), j)) / sheet_.ds;
    const Point<3> bend_r = (slope_r(i, std::min(j, m_ - 2)) - slope_r(i, std::max(j - 1, 0L))) / sheet_.dr;
    const Point<3> twist = (tangent_r(std::min(i + 1, n_ - 1), j) - tangent_r(std::max(i - 1, 0L), j)) /
                           (sheet_.ds * static_cast<double>(std::min(i + 1, n_ - 1) - std::max(i - 1, 0L)));
    const double kappa_s = normal.dot(bend_s) / a.squaredNorm(), kappa_r = normal.dot(bend_r) / b.squaredNorm();
    m11_.push_back(moduli_.kb_s * (kappa_s + moduli_.poisson * kappa_r));
    m22_.push_back(moduli_.kb_r * (kappa_r + moduli_.poisson * kappa_s));
    m12_.push_back(moduli_.kt * normal.dot(twist) / (a.norm() * b.norm()));
  }
  // Half a spacing beyond the outermost markers M_b,11 and M_b,22 vanish: there they are a third of the next ones.
  void vanish_at_edges(long i, long j) {
    if (n_ > 2 && (i == 0 || i == n_ - 1)) m11_[number(i, j)] = at(m11_, i == 0 ? 1 : n_ - 2, j) / 3;
    if (m_ > 2 && (j == 0 || j == m_ - 1)) m22_[number(i, j)] = at(m22_, i, j == 0 ? 1 : m_ - 2) / 3;
  }
  // Differences of M_b,12 at a marker, which is zero beyond the edges: its jump there is Kirchhoff's edge shear.
  double slope_of_m12_r(long i, long j) const {
    const double above = j + 1 < m_ ? 0.5 * (at(m12_, i, j) + at(m12_, i, j + 1)) : 0;
    const double below = j > 0 ? 0.5 * (at(m12_, i, j - 1) + at(m12_, i, j)) : 0;
    return above - below;
  }
  double slope_of_m12_s(long i, long j) const {
    const double above = i + 1 < n_ ? 0.5 * (at(m12_, i, j) + at(m12_, i + 1, j)) : 0;
    const double below = i > 0 ? 0.5 * (at(m12_, i - 1, j) + at(m12_, i, j)) : 0;
    return above - below;
  }

  const Sheet& sheet_;
  const LinearModuli& moduli_;
  std::span<const Point<3>> x_;
  long n_, m_;
  std::vector<double> m11_, m22_, m12_;
};

}  // namespace

void add_love_forces(const Sheet& sheet, std::span<const Point<3>> positions, std::span<Point<3>> forces) {
  const long m = static_cast<long>(sheet.width), n = static_cast<long>(positions.size()) / m;
  const Plate plate(sheet, positions);
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < m; ++j)
      forces[i * m + j] += sheet.dr * (plate.flux_s(i, j) - plate.flux_s(i - 1, j)) +
                           sheet.ds * (plate.flux_r(i, j) - plate.flux_r(i, j - 1));
}

}  // namespace washfsi
