// SPDX-License-Identifier: BSD-3-Clause
//
// The explicit step, thesis 3.4 for three dimensions:
//   1. forces       F^n = elastic and damping forces at X^n, U^n, excess weight, loads, contact with bodies
//   2. spread       rho = rho_f + S(X^n) m,    f = S(X^n) F^n
//   3. bodies       mask H and solid velocity at t^(n+1)
//   4. fluid        u^(n+1), p^(n+1/2) by the fractional step
//   5. markers      U^(n+1) = J(X^n) [H u^(n+1) + (1-H) u_solid],    X^(n+1) = X^n + dt U^(n+1)
// The marker moves with the NEW velocity: with u^n the step is unstable at any useful length.
#pragma once

#include "washfsi/coupling/coupling_scheme.hpp"

namespace washfsi {

template <int Dim>
class ExplicitCoupling : public CouplingScheme<Dim> {
  void advance_fields(System<Dim>& system, double dt) override;
};

}  // namespace washfsi
