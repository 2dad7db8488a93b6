// SPDX-License-Identifier: BSD-3-Clause
//
// The thesis's strong form of the cloth's equations on its own lattice (3.4.1): a baseline for verification. It does
// not conserve angular momentum, has no energy and no Jacobian. The sheet's fabric must be linear.
#pragma once

#include "washfsi/cloth/sheet.hpp"

namespace washfsi {

/// Adds the force of a fibre in 2D (3.3.4): F_A ds with
///   F_A = d/ds (N X_s) + d/ds (Q n),  N = K_e E11,  M_b = K_b n.X_ss/|X_s|^2,  Q = -(1/|X_s|) dM_b/ds,
/// and N, M_b and Q zero at the ends.
void add_love_forces(const Sheet& sheet, std::span<const Point<2>> positions, std::span<Point<2>> forces);

/// Adds the force of an isotropic plate in 3D (3.3.3): F_A ds dr with
///   F_A = d/ds (N11 X_s + N12 X_r + Q1 |X_r| n) + d/dr (N12 X_s + N22 X_r + Q2 |X_s| n)      (3.3-26, 3.3-31)
///   Q1 = -(dM_b,11/dl_s + dM_b,12/dl_r),  Q2 = -(dM_b,12/dl_s + dM_b,22/dl_r)                (3.3-35)
/// with l_s and l_r the lengths along the deformed cloth. N and Q are zero at the free edges, M_b beyond them.
void add_love_forces(const Sheet& sheet, std::span<const Point<3>> positions, std::span<Point<3>> forces);

}  // namespace washfsi
