// SPDX-License-Identifier: BSD-3-Clause
//
// Elasticity of a sheet: a lattice of n_s x n_r markers X_ij, i along s (warp), j along r (weft), with the spacings ds
// and dr on the undeformed cloth. Its edges lie half a spacing beyond the outermost markers or, on a nodal lattice, at
// them (cloth/marker_row.hpp). Marker (i, j) has the number i n_r + j. A fibre is a sheet one marker wide.
// Formulation 3.1, 3.2, thesis 3.3.3 to 3.3.5.
//
// Energy form (default): the forces are F_ij = -dPsi/dX_ij, and all conditions at free edges are natural. With the
// energies per area and the bending moduli of a constitutive model (cloth/fabric_law.hpp), Psi is
//     sum over s-edges    w_j ds dr warp(E11, bare),  E11 = (|X_(i+1,j) - X_ij|^2/ds^2 - 1)/2
//   + sum over r-edges    w_i ds dr weft(E22, bare),  E22 likewise
//   + sum over quads      ds dr quad(E11 of two edges, E22 of two edges, 2 E12),  2 E12 = <X_s>.<X_r>
//   + sum over markers    1/2 w_i w_j ds dr (w_b K_b,s |X_ss|^2 + w_b K_b,r |X_rr|^2 + 2 cross X_ss.X_rr)
//   + sum over quads      w_t ds dr K_t |X_sr|^2
// <X_s> and <X_r> are the mean tangents of a quad, X_ss and X_rr second differences, absent where a neighbour is
// missing, and X_sr the mixed one. `cross` is nu_P sqrt(K_b,s K_b,r) in the linear model. w_b is not 1 where X_ss
// or X_rr is missing, and w_i and w_j are the shares of rows and columns. On the centred lattice these are 1. Half a
// spacing round its markers there are no quads: an edge is bare on one or both sides there, and w_t has a factor 3/2
// for each side without a next row of quads. On the nodal lattice quads fill the cloth: the shares are 1/2 on its
// edges, and w_t = 1. The form conserves linear and angular momentum to round-off and cannot create energy.
// Bending is linear in X, so that nothing is singular on crumpled cloth.
#pragma once

#include <functional>
#include <span>

#include "washfsi/cloth/fabric.hpp"
#include "washfsi/cloth/marker_row.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Lattice and fabric of a sheet. In 2D all is per unit depth, which then is `dr`.
struct Sheet {
  std::size_t width = 1;  ///< markers along r, n_r
  double ds = 0, dr = 1;  ///< spacings [m]
  Fabric fabric{};        ///< law of its fabric
  double damping = 0;     ///< Kelvin-Voigt time beta of the edges [s]
  double thickness = 1;   ///< [m], for stresses only
  bool closed = false;    ///< a ring along s: no ends
  MarkerLattice lattice = MarkerLattice::centred;
  double held_water = 1;  ///< water in its pores, which it carries along itself [kg/m2]

  /// Undeformed area of a marker inside the sheet [m2; m in the plane].
  double part_area() const { return ds * dr; }
};

/// A block of the stiffness K = d2Psi/dX2 between two markers [N/m; per unit depth in 2D].
template <int Dim>
using StiffnessBlock = Block<Dim>;

/// A callback that adds the block of a row and a column.
template <int Dim>
using AddBlock = std::function<void(std::size_t row, std::size_t column, const StiffnessBlock<Dim>& block)>;

/// The part of the geometric stiffness, which stems from the stresses and not from the moduli, that enters a matrix:
/// all of it, or only that of edges in tension; with the latter the matrix is positive definite if the law's tangents
/// are.
enum class GeometricStiffness { all, of_tension };

/// The functions below act on neighbouring rows of one sheet (a row: all markers of one i). Given only some of its
/// rows, they are exact for all markers that are at least this many rows from those where it was cut.
inline constexpr int sheet_reach = 3;

/// Adds -dPsi/dX [N; per unit depth in 2D].
template <int Dim>
void add_energy_forces(const Sheet& sheet, std::span<const Point<Dim>> positions, std::span<Point<Dim>> forces);

/// Adds the exact Jacobian of -forces, K = d2Psi/dX2, block by block.
template <int Dim>
void add_energy_stiffness(const Sheet& sheet, std::span<const Point<Dim>> positions, GeometricStiffness geometric,
                          const AddBlock<Dim>& add);

/// Adds -K d for a direction d: the rate of change of the forces as the markers move along it.
template <int Dim>
void add_energy_force_rates(const Sheet& sheet, std::span<const Point<Dim>> positions,
                            std::span<const Point<Dim>> direction, std::span<Point<Dim>> rates);

/// Adds the Kelvin-Voigt damping of the edges. Along s it is the tension beta N' dE11/dt, with N' = dN/dE11 at the
/// strain of the edge. On the markers this is the force beta N' dr l (l . dV)/ds^3, with l the edge and dV the
/// difference of their velocities.
template <int Dim>
void add_damping_forces(const Sheet& sheet, std::span<const Point<Dim>> positions,
                        std::span<const Point<Dim>> velocities, std::span<Point<Dim>> forces);

/// Elastic energy of the edges, quads and bends that belong to markers first..last-1: an edge to its first marker, a
/// quad to its lowest.
template <int Dim>
double elastic_energy(const Sheet& sheet, std::span<const Point<Dim>> positions, std::size_t first, std::size_t last);

/// A quarter of the largest eigenvalue of the stiffness per area: of stretching and shear, and of bending and twist
/// [N/m3].
double largest_stiffness(const Sheet& sheet);

/// The size of the terms whose difference is the force on a marker, at a distance from the origin [N].
double cancelling_size(const Sheet& sheet, double distance);

}  // namespace washfsi
