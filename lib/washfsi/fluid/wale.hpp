// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/velocity_gradient.hpp"

namespace washfsi {

/// Nicoud and Ducros, Flow Turbul. Combust. 62 (1999) 183: with alpha the gradient of the velocity, e its symmetric
/// part, Lambda the symmetric part of alpha^2 without its trace, and Delta the cube root of the cell volume,
///   nu_t = (c_w Delta)^2 (Lambda : Lambda)^(3/2) / ( (e : e)^(5/2) + (Lambda : Lambda)^(5/4) ).
/// It is zero in pure shear, not in solid-body rotation. c_w = 0.5 by default.
class Wale {
 public:
  Wale(double constant, const Point<3>& sides);
  double operator()(const Gradient<3>& gradient) const;

 private:
  double square_;  ///< (c_w Delta)^2 [m2]
};

}  // namespace washfsi
