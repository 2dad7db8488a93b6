// SPDX-License-Identifier: BSD-3-Clause
//
// Elasticity of a fibre: a line of markers X_k, spacing ds on the undeformed cloth, ends half a spacing beyond the
// first and last marker. Formulation 3.1, thesis 3.3.4.
//
// Energy form (default), forces F_k = -dE/dX_k, free ends without further conditions:
//   E = sum over edges    1/2 Ke ds E11^2,   E11 = (|X_(k+1) - X_k|^2/ds^2 - 1)/2
//     + sum over markers  1/2 Kb ds |D|^2,   D = (X_(k+1) - 2 X_k + X_(k-1))/ds^2   (inner markers)
// It conserves linear and angular momentum to round-off and cannot create energy.
#pragma once

#include <functional>
#include <span>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// Stiffness and lattice of a fibre, per unit depth in the plane.
struct Fibre {
  double spacing = 0;    ///< ds [m]
  double ke = 0;         ///< extensional stiffness Ke [N/m]
  double kb = 0;         ///< bending stiffness Kb [N m]
  double damping = 0;    ///< Kelvin-Voigt time beta of the edges [s]
  double thickness = 1;  ///< q [m], for stresses only
  bool closed = false;   ///< a ring: no ends
};

/// A block of a stiffness matrix K = d2E/dX2, between two markers [N/m; per unit depth in the plane].
template <int Dim>
using StiffnessBlock = Eigen::Matrix<double, Dim, Dim>;

/// Takes the block of a row and a column, to be added to what is there.
template <int Dim>
using AddBlock = std::function<void(std::size_t row, std::size_t column, const StiffnessBlock<Dim>& block)>;

/// How much of an edge's geometric stiffness, T/ds times the identity, enters a matrix: all of it, or only where the
/// edge is in tension. Without that of compressed edges the matrix is positive definite.
enum class GeometricStiffness { all, of_tension };

/// The functions below act on neighbouring markers of one fibre. Given only a part of a fibre, they are exact for
/// all markers that are at least this far from the part's cut ends.
inline constexpr int fibre_reach = 3;

/// Green strain E11 of each edge times Ke: the tension T (second Piola) [N/m]; one value fewer than markers.
template <int Dim>
std::vector<double> tensions(const Fibre& fibre, std::span<const Point<Dim>> positions);

/// Adds -dE/dX of stretching and bending [N; per unit depth in the plane].
template <int Dim>
void add_energy_forces(const Fibre& fibre, std::span<const Point<Dim>> positions, std::span<Point<Dim>> forces);

/// Adds the exact Jacobian of -forces, K = d2E/dX2, block by block.
template <int Dim>
void add_energy_stiffness(const Fibre& fibre, std::span<const Point<Dim>> positions, GeometricStiffness geometric,
                          const AddBlock<Dim>& add);

/// Adds the Kelvin-Voigt damping of the edges, beta Ke d (d . dU)/ds^3 with d the edge vector.
template <int Dim>
void add_damping_forces(const Fibre& fibre, std::span<const Point<Dim>> positions,
                        std::span<const Point<Dim>> velocities, std::span<Point<Dim>> forces);

/// Adds the thesis's strong form (3.3.4, 3.4.1) in the plane: F ds with
///   F = d/ds (T X_s) + d/ds (Q e3),  T = Ke E11,  M = Kb kappa,  Q = -(1/K) dM/ds,
/// T, M and Q zero at the ends. A baseline: it does not conserve angular momentum.
void add_love_forces(const Fibre& fibre, std::span<const Point<2>> positions, std::span<Point<2>> forces);

/// Elastic energy of the edges and bends that belong to markers first..last-1 (an edge to its first marker).
template <int Dim>
double elastic_energy(const Fibre& fibre, std::span<const Point<Dim>> positions, std::size_t first, std::size_t last);

/// What a marker bears. The stress at the surface of the cloth is the sum of both (5.2-2).
struct MarkerState {
  double membrane_stress = 0;  ///< |T|/q, T the mean of the two edges beside, zero beyond an end [Pa]
  double bending_stress = 0;   ///< 6 |M|/q^2 [Pa]
  double stretch = 0;          ///< mean of | |X_s| - 1 | of the edges beside
  double curvature = 0;        ///< |X_ss| [1/m]
};

/// The state at each marker.
template <int Dim>
std::vector<MarkerState> marker_states(const Fibre& fibre, std::span<const Point<Dim>> positions);

}  // namespace washfsi
