// SPDX-License-Identifier: BSD-3-Clause
//
// The thesis's strong form of a fibre in 2D, on its own lattice (Fig. 3.4-1): quantities at staggered points j + 1/2
// between the markers j and j + 1, and at the two ends, where the tension N, the moment M_b and the shear force Q are
// zero.
#include "washfsi/cloth/love.hpp"

namespace washfsi {

namespace {

/// Staggered values: index j + 1 is the point between markers j and j + 1; 0 and n are the ends (n markers).
using Staggered = std::vector<double>;

}  // namespace

void add_love_forces(const Sheet& sheet, std::span<const Point<2>> positions, std::span<Point<2>> forces) {
  const auto& x = positions;
  const std::size_t n = x.size();
  const double ds = sheet.ds;
  const LinearModuli& moduli = std::get<LinearFabric>(sheet.fabric).moduli();
  if (n < 2) return;

  std::vector<Point<2>> slope(n + 1, Point<2>::Zero()), normal(n + 1, Point<2>::Zero());  // X_s and n, staggered
  Staggered tension(n + 1, 0.0), moment(n + 1, 0.0), shear(n + 1, 0.0);
  for (std::size_t j = 1; j < n; ++j) {
    slope[j] = (x[j] - x[j - 1]) / ds;
    normal[j] = turned_left<2>(slope[j].normalized());
    tension[j] = moduli.ke_s * 0.5 * (slope[j].squaredNorm() - 1);
  }
  slope[0] = slope[1];  // no moment, no change of slope at the ends
  slope[n] = slope[n - 1];

  // M_b at staggered points: n.X_ss/|X_s|^2 from the slopes at the two markers beside
  for (std::size_t j = 1; j < n; ++j) {
    const Point<2> at_left = 0.5 * (slope[j - 1] + slope[j]), at_right = 0.5 * (slope[j] + slope[j + 1]);
    moment[j] = moduli.kb_s * normal[j].dot(at_right - at_left) / ds / slope[j].squaredNorm();
  }

  // Q at markers, then at staggered points
  std::vector<double> shear_at_marker(n);
  for (std::size_t k = 0; k < n; ++k)
    shear_at_marker[k] = -(moment[k + 1] - moment[k]) / ds / (0.5 * (slope[k] + slope[k + 1])).norm();
  for (std::size_t j = 1; j < n; ++j) shear[j] = 0.5 * (shear_at_marker[j - 1] + shear_at_marker[j]);

  for (std::size_t k = 0; k < n; ++k)  // F_A ds
    forces[k] +=
        tension[k + 1] * slope[k + 1] - tension[k] * slope[k] + shear[k + 1] * normal[k + 1] - shear[k] * normal[k];
}

}  // namespace washfsi
