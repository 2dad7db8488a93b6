// SPDX-License-Identifier: BSD-3-Clause
//
// Fluid and bodies without cloth:
//   1. bodies       mask H and solid velocity at t^(n+1)
//   2. fluid        u^(n+1), p^(n+1/2) by the fractional step
#pragma once

#include "washfsi/coupling/coupling_scheme.hpp"

namespace washfsi {

template <int Dim>
class FluidAlone : public CouplingScheme<Dim> {
  void advance_fields(System<Dim>& system, double dt) override;
};

}  // namespace washfsi
