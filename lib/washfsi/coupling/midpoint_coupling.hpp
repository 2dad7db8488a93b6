// SPDX-License-Identifier: BSD-3-Clause
//
// The midpoint step, second order, after Lai and Peskin (J. Comput. Phys. 160 (2000) 705):
//   1. half step    X^(n+1/2) = X^n + dt/2 U^n
//   2. forces       F = elastic and damping forces at X^(n+1/2), U^n, excess weight, loads, contact with bodies
//   3. spread       rho = rho_f + S(X^(n+1/2)) m,    f = S(X^(n+1/2)) F
//   4. bodies       mask H and solid velocity at t^(n+1)
//   5. fluid        u^(n+1), p^(n+1/2) by the fractional step
//   6. markers      X^(n+1) = X^n + dt/2 J(X^(n+1/2)) [u_H^n + u_H^(n+1)],    U^(n+1) = J(X^(n+1)) u_H^(n+1)
// with u_H = H u + (1-H) u_solid. On a linear spring it is the leapfrog scheme: up to the explicit bound it neither
// damps nor excites an oscillation.
#pragma once

#include "washfsi/coupling/coupling_scheme.hpp"

namespace washfsi {

template <int Dim>
class MidpointCoupling : public CouplingScheme<Dim> {
  void advance_fields(System<Dim>& system, double dt) override;
};

}  // namespace washfsi
