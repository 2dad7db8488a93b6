// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/velocity_gradient.hpp"

namespace washfsi {

/// Vreman, Phys. Fluids 16 (2004) 3670, with the sides h_d of the cell one by one:
///   nu_t = c_V sqrt( II / (alpha : alpha) ),   alpha_ij = du_i/dx_j,   Gamma_ij = sum_d h_d^2 alpha_id alpha_jd,
/// with II the second invariant of Gamma, the sum of its principal minors of order two. nu_t is zero in pure shear, not
/// in solid-body rotation. c_V = 0.07 by default, which is 2.5 times the square of Smagorinsky's constant.
class Vreman {
 public:
  Vreman(double constant, const Point<3>& sides) : constant_(constant), sides_(sides) {}
  double operator()(const Gradient<3>& gradient) const;

 private:
  double constant_;
  Point<3> sides_;
};

}  // namespace washfsi
