// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

/// Karman's constant in the law below.
inline constexpr double karman = 0.41;

/// Reichardt's law (Z. angew. Math. Mech. 31 (1951) 208) of the mean velocity along a smooth wall, over the friction
/// speed u_tau, at y+ = y u_tau/nu:
///   u+ = ln(1 + 0.41 y+)/0.41 + 7.8 (1 - exp(-y+/11) - y+/11 exp(-y+/3))
/// near y+ in the viscous layer, logarithmic far out.
double reichardt(double y_plus);

/// y+ where the flow has this Reynolds number u y/nu = u+ y+ (0 or more) by that law.
double wall_distance(double reynolds);

}  // namespace washfsi
