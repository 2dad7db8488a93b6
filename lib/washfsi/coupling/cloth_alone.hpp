// SPDX-License-Identifier: BSD-3-Clause
//
// Cloth without fluid, by the velocity form of Verlet's method (second order). With the masses m of the markers, all
// forces F and the drag  -c V  per undeformed area A of a marker:
//   1. half step    (m + dt/2 c A) V^(n+1/2) = m V^n + dt/2 F(X^n)
//   2. markers      X^(n+1) = X^n + dt V^(n+1/2)
//   3. half step    (m + dt/2 c A) V^(n+1)   = m V^(n+1/2) + dt/2 F(X^(n+1))
#pragma once

#include "washfsi/coupling/coupling_scheme.hpp"

namespace washfsi {

template <int Dim>
class ClothAlone : public CouplingScheme<Dim> {
  void advance_fields(System<Dim>& system, double dt) override;
};

}  // namespace washfsi
