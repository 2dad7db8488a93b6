// SPDX-License-Identifier: BSD-3-Clause
//
// Elasticity of a sheet: a lattice of n x m markers X_ij, i along s (warp), j along r (weft), spacings ds and dr on the
// undeformed cloth, edges half a spacing beyond the outermost markers or, on a nodal lattice, at them
// (cloth/marker_row.hpp). Marker (i, j) has the number i m + j. A fibre is a sheet one marker wide.
// Formulation 3.1, 3.2, thesis 3.3.3 to 3.3.5.
//
// Energy form (default), forces F_ij = -dE/dX_ij; all conditions at free edges are natural. With the energies per area
// and the bending moduli of a law of fabric (cloth/fabric_law.hpp):
//   E = sum over s-edges    c_j ds dr warp(E11, bare),  E11 = (|X_(i+1,j) - X_ij|^2/ds^2 - 1)/2
//     + sum over r-edges    c_i ds dr weft(E22, bare),  E22 likewise
//     + sum over quads      ds dr quad(E11 of two edges, E22 of two edges, a.b)
//     + sum over markers    1/2 c_i c_j ds dr (f B_s |D_s|^2 + f B_r |D_r|^2 + 2 B_sr D_s.D_r)
//     + sum over quads      g ds dr B_t |D_q|^2
// a and b are a quad's mean tangents X_s and X_r, so that a.b = 2 E12; D_s and D_r second differences (absent where a
// neighbour is missing), D_q the mixed one, f is not 1 where D_s or D_r is absent, and c_i and c_j are the shares of
// rows and columns. On the centred lattice they are 1; the strip of half a spacing round the markers has no quads:
// there an edge is bare on one or both sides, and g = 1 + 1/2 per side without a next row of quads. On the nodal one
// quads fill the cloth, c = 1/2 on its edges, and g = 1. The form conserves linear and angular momentum to round-off
// and cannot create energy; bending is linear in X, so that nothing is singular on crumpled cloth.
#pragma once

#include <functional>
#include <span>

#include "washfsi/cloth/fabric.hpp"
#include "washfsi/cloth/marker_row.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Lattice and fabric of a sheet. In the plane all is per unit depth, which then is `dr`.
struct Sheet {
  std::size_t width = 1;  ///< markers along r, m
  double ds = 0, dr = 1;  ///< spacings [m]
  Fabric fabric{};        ///< law of its fabric
  double damping = 0;     ///< Kelvin-Voigt time beta of the edges [s]
  double thickness = 1;   ///< q [m], for stresses only
  bool closed = false;    ///< a ring along s: no ends
  MarkerLattice lattice = MarkerLattice::centred;

  /// Undeformed area of a marker inside the sheet [m2; m in the plane].
  double part_area() const { return ds * dr; }
};

/// A block of a stiffness matrix K = d2E/dX2, between two markers [N/m; per unit depth in the plane].
template <int Dim>
using StiffnessBlock = Eigen::Matrix<double, Dim, Dim>;

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

/// Adds -dE/dX [N; per unit depth in the plane].
template <int Dim>
void add_energy_forces(const Sheet& sheet, std::span<const Point<Dim>> positions, std::span<Point<Dim>> forces);

/// Adds the exact Jacobian of -forces, K = d2E/dX2, block by block.
template <int Dim>
void add_energy_stiffness(const Sheet& sheet, std::span<const Point<Dim>> positions, GeometricStiffness geometric,
                          const AddBlock<Dim>& add);

/// Adds -K d for a direction d: the rate of change of the forces as the markers move along it.
template <int Dim>
void add_energy_force_rates(const Sheet& sheet, std::span<const Point<Dim>> positions,
                            std::span<const Point<Dim>> direction, std::span<Point<Dim>> rates);

/// Adds the Kelvin-Voigt damping of the edges: along s the resultant beta k dE11/dt, k the fabric's modulus at E11,
/// which is the force beta k dr d (d . dU)/ds^3 with d the edge vector.
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
