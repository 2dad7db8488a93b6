// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/velocity_gradient.hpp"

namespace washfsi {

/// Nicoud and Ducros, Flow Turbul. Combust. 62 (1999) 183: with g the gradient, S its symmetric part, Sd the symmetric
/// part of g^2 without its trace, and D the cube root of the cell's volume,
///   nu_t = (C D)^2 (Sd : Sd)^(3/2) / ( (S : S)^(5/2) + (Sd : Sd)^(5/4) ).
/// Zero in pure shear, not in solid-body rotation. C = 0.5.
class Wale {
 public:
  Wale(double constant, const Point<3>& sides);
  double operator()(const Gradient<3>& gradient) const;

 private:
  double square_;  ///< (C D)^2 [m2]
};

}  // namespace washfsi
