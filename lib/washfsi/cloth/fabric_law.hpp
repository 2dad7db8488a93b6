// SPDX-License-Identifier: BSD-3-Clause
//
// The interface of a law of fabric to the lattice of a sheet (cloth/sheet.hpp). The energy of the membrane lies partly
// on the lattice's edges, partly on its quads, each per undeformed area:
//   sum over s-edges  ds dr warp(E11, bare)  +  sum over r-edges  ds dr weft(E22, bare)
//     +  sum over quads  ds dr quad(E11 of two edges, E22 of two edges, 2 E12)
// E are the Green-Lagrange strains. Half of an edge's area is on either side of it; `bare` = 0, 1/2 or 1 is the share
// that has no quad, at the border of the cloth, where the stress across the edge is zero. A law whose energy is a
// function of all three strains at a point has it all on the quads (tests/support/pointwise_quad.hpp), and on the edges
// only that of their bare share.
//
// To add a law: a class of this kind in two new files, and its name in the list of cloth/fabric.hpp.
#pragma once

#include <array>
#include <concepts>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// The energy per area of an edge [J/m2] at a strain E; its first derivative, the resultant N [N/m]; and its second,
/// the tangent modulus dN/dE [N/m].
struct EdgeResponse {
  double energy = 0, resultant = 0, tangent = 0;
};

/// Strains of a quad, in this order: E11 of its first and second edge along s, E22 of its first and second edge along
/// r, and 2 E12; or their rates; or the resultants that do work on them, the derivatives of its energy per area [N/m].
using QuadVector = Eigen::Matrix<double, 5, 1>;
/// Second derivatives of a quad's energy per area [N/m].
using QuadMatrix = Eigen::Matrix<double, 5, 5>;

/// Which of a quad's strains are those at its corner p = 0..3, in the order of its markers: row by row.
constexpr std::array<int, 3> strains_at_corner(int p) {
  return {p % 2, 2 + p / 2, 4};
}

/// Second derivatives of an energy per area that couples no more than the means of a quad's edges,
///   coupling <E11> <E22> + 1/2 shear (2 E12)^2    [N/m]
struct MeanTangent {
  double coupling = 0, shear = 0;

  QuadVector operator*(const QuadVector& rates) const {
    const double from_s = 0.25 * coupling * (rates[0] + rates[1]), from_r = 0.25 * coupling * (rates[2] + rates[3]);
    return {from_r, from_r, from_s, from_s, shear * rates[4]};
  }
};

/// Bending, with the second differences X_ss and X_rr and the mixed one X_sr. Its energy per area is
///   1/2 w_b s |X_ss|^2 + 1/2 w_b r |X_rr|^2 + cross X_ss . X_rr + twist |X_sr|^2,
/// with w_b = `alone` where only one of X_ss and X_rr exists, else 1. The moduli in [N m] are K_b,s, K_b,r, that which
/// couples the two, and K_t.
struct BendingModuli {
  double s = 0, r = 0, cross = 0, twist = 0;
  double alone = 1;
};

/// Bounds of the membrane's tangent moduli over the strains of the law's range: of dN11/dE11, dN22/dE22 and
/// dN12/d(2 E12) [N/m]; and of dN11/dE22 over the root of the first two.
struct LargestModuli {
  double s = 0, r = 0, shear = 0, poisson = 0;
};

/// The energy per area of a quad at its strains, and its derivatives.
template <class Response>
concept QuadResponse = requires(const Response& response, const QuadVector& rates) {
  { response.energy() } -> std::convertible_to<double>;
  { response.resultants() } -> std::convertible_to<QuadVector>;
  { response.tangent() * rates } -> std::convertible_to<QuadVector>;  ///< a MeanTangent or a QuadMatrix
};

/// A law of fabric, a value. Without strain there are no resultants.
template <class Law>
concept FabricLaw = std::copyable<Law> && requires(const Law& law, OptionBlock& block, std::size_t directions,
                                                   double strain, double bare, const QuadVector& strains) {
  /// The name of the law for users (-NAME_fabric).
  { Law::name } -> std::convertible_to<std::string>;
  /// Declares, reads and checks its options, along warp alone (1) or along warp and weft (2). Errors: InputError.
  { Law::from_options(block, directions) } -> std::same_as<Law>;
  /// The response of an edge along warp or weft.
  { law.warp(strain, bare) } -> std::same_as<EdgeResponse>;
  { law.weft(strain, bare) } -> std::same_as<EdgeResponse>;
  { law.quad(strains) } -> QuadResponse;
  /// Tangent modulus of stretching along warp or weft alone [N/m], which the damping of an edge is proportional to.
  { law.warp_modulus(strain) } -> std::convertible_to<double>;
  { law.weft_modulus(strain) } -> std::convertible_to<double>;
  { law.bending() } -> std::convertible_to<BendingModuli>;
  { law.largest_moduli() } -> std::convertible_to<LargestModuli>;
};

}  // namespace washfsi
