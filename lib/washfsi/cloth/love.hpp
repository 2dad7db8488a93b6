// SPDX-License-Identifier: BSD-3-Clause
//
// The thesis's strong form of the cloth's equations on its own lattice (3.4.1): a baseline for verification. It does
// not conserve angular momentum, has no energy and no Jacobian. The sheet's fabric must be linear.
#pragma once

#include "washfsi/cloth/sheet.hpp"

namespace washfsi {

/// Adds the force of a fibre in the plane (3.3.4): F ds with
///   F = d/ds (T X_s) + d/ds (Q e3),  T = Ke E11,  M = Kb kappa,  Q = -(1/K) dM/ds,
/// T, M and Q zero at the ends.
void add_love_forces(const Sheet& sheet, std::span<const Point<2>> positions, std::span<Point<2>> forces);

/// Adds the force of an isotropic plate in space (3.3.3): F ds dr with
///   F = d/ds (N11 X_s + N12 X_r + Q1 |X_r| e3) + d/dr (N12 X_s + N22 X_r + Q2 |X_s| e3)    (3.3-26, 3.3-31)
///   Q1 = -(dM11/dsigma_s + dM12/dsigma_r),  Q2 = -(dM12/dsigma_s + dM22/dsigma_r)          (3.3-35)
/// N and Q zero at the free edges, M beyond them.
void add_love_forces(const Sheet& sheet, std::span<const Point<3>> positions, std::span<Point<3>> forces);

}  // namespace washfsi
