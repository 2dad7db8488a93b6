// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

namespace washfsi {

/// The fluid fraction H as a function of the signed distance Phi from a surface, positive in fluid (thesis 4.2). Sharp:
/// 0 in the solid, 1/2 on its surface, 1 in fluid. Smooth over |Phi| < eps:  H = 1/2 (1 + Phi/eps + sin(pi
/// Phi/eps)/pi).
struct FluidFraction {
  double half_width;  ///< eps [m]; 0: sharp
  double on_surface;  ///< distance within which a place counts as on the surface, against round-off [m]

  double operator()(double distance) const {
    if (std::abs(distance) >= half_width) return distance > on_surface ? 1 : distance < -on_surface ? 0 : 0.5;
    const double x = distance / half_width;
    return 0.5 * (1 + x + std::sin(std::numbers::pi * x) / std::numbers::pi);
  }
};

}  // namespace washfsi
