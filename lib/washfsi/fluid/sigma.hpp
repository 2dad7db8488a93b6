// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/velocity_gradient.hpp"

namespace washfsi {

/// Nicoud, Baya Toda, Cabrit, Bose and Lee, Phys. Fluids 23 (2011) 085106: with the singular values s1 >= s2 >= s3 of
/// the gradient, and D the cube root of the cell's volume,
///   nu_t = (C D)^2 s3 (s1 - s2) (s2 - s3) / s1^2.
/// Zero in flows of two dimensions or components, and in solid-body rotation. C = 1.35.
class Sigma {
 public:
  Sigma(double constant, const Point<3>& sides);
  double operator()(const Gradient<3>& gradient) const;

 private:
  double square_;  ///< (C D)^2 [m2]
};

}  // namespace washfsi
