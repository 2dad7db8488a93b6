// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/velocity_gradient.hpp"

namespace washfsi {

/// Nicoud, Baya Toda, Cabrit, Bose and Lee, Phys. Fluids 23 (2011) 085106: with the singular values sigma_1 >= sigma_2
/// >= sigma_3 of the gradient alpha of the velocity, and Delta the cube root of the cell volume,
///   nu_t = (c_sigma Delta)^2 sigma_3 (sigma_1 - sigma_2) (sigma_2 - sigma_3) / sigma_1^2.
/// It is zero in flows of two dimensions or components, and in solid-body rotation. c_sigma = 1.35 by default.
class Sigma {
 public:
  Sigma(double constant, const Point<3>& sides);
  double operator()(const Gradient<3>& gradient) const;

 private:
  double square_;  ///< (c_sigma Delta)^2 [m2]
};

}  // namespace washfsi
