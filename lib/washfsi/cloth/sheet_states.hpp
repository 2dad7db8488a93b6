// SPDX-License-Identifier: BSD-3-Clause
//
// Measures of deformed sheets: normals, stresses, deformation.
#pragma once

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Largest stretch |X_s| - 1 or |X_r| - 1 of any edge.
template <int Dim>
double largest_stretch(const Sheet& sheet, std::span<const Point<Dim>> positions);

/// Unit normal n at each marker, in 2D to the left of the fibre.
template <int Dim>
Points<Dim> normals(const Sheet& sheet, std::span<const Point<Dim>> positions);

/// The unit vectors along s and r that point out of the cloth at the edge where a marker is; zero elsewhere.
template <int Dim>
struct Outwards {
  Point<Dim> s = Point<Dim>::Zero(), r = Point<Dim>::Zero();
};

/// Those at each marker.
template <int Dim>
std::vector<Outwards<Dim>> outwards(const Sheet& sheet, std::span<const Point<Dim>> positions);

/// Components of stress: along warp, along weft, shear. In the plane there is only the first.
enum StressComponent : std::size_t { ss, rr, sr, stress_components };

/// Stresses and deformation at a marker. The stress at the cloth's surface is the sum of both (5.2-2 to 5.2-4).
struct MarkerState {
  std::array<double, stress_components> membrane_stress{};  ///< |N|/thickness, N the mean over the edges or quads
                                                            ///< beside, zero beyond a centred lattice [Pa]
  std::array<double, stress_components> bending_stress{};   ///< 6 |M_b|/thickness^2 [Pa]
  double stretch = 0;                                       ///< mean of | |X_s| - 1 | over the edges beside, zero
                                                            ///< beyond a centred lattice
  double curvature = 0;                                     ///< sqrt(|X_ss|^2 + |X_rr|^2 + 2 |X_sr|^2) [1/m]
  double shear_angle = 0;                                   ///< mean of the quads beside [rad]
};

/// Computes the state at each marker.
template <int Dim>
std::vector<MarkerState> marker_states(const Sheet& sheet, std::span<const Point<Dim>> positions);

/// Unit normal of the cloth at each of this rank's markers. Collective.
template <int Dim>
Points<Dim> normals(const Cloths<Dim>& cloths, const Points<Dim>& positions);

/// The directions out of the cloth at each of this rank's markers. Collective.
template <int Dim>
std::vector<Outwards<Dim>> outwards(const Cloths<Dim>& cloths, const Points<Dim>& positions);

/// Stress and deformation at each of this rank's markers. Collective.
template <int Dim>
std::vector<MarkerState> marker_states(const Cloths<Dim>& cloths, const Points<Dim>& positions);

/// Largest stretch |X_s| - 1 or |X_r| - 1 of any edge in each group. Collective.
template <int Dim>
std::vector<double> largest_stretches(const Cloths<Dim>& cloths, const Points<Dim>& positions);

}  // namespace washfsi
