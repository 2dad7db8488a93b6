// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/velocity_gradient.hpp"

namespace washfsi {

/// Vreman, Phys. Fluids 16 (2004) 3670, with the cell's sides D_m one by one:
///   nu_t = c sqrt( B / (a : a) ),   a_mi = du_i/dx_m,   b_ij = sum_m D_m^2 a_mi a_mj,
///   B = the sum of b's principal minors of order two.
/// Zero in pure shear, not in solid-body rotation. c = 2.5 Cs^2 = 0.07.
class Vreman {
 public:
  Vreman(double constant, const Point<3>& sides) : constant_(constant), sides_(sides) {}
  double operator()(const Gradient<3>& gradient) const;

 private:
  double constant_;
  Point<3> sides_;
};

}  // namespace washfsi
