// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "washfsi/simulation/system.hpp"

namespace washfsi {

/// A way of advancing cloth and water together by one time step.
template <int Dim>
class CouplingScheme {
 public:
  CouplingScheme() = default;
  CouplingScheme(const CouplingScheme&) = delete;
  CouplingScheme& operator=(const CouplingScheme&) = delete;
  virtual ~CouplingScheme() = default;
  /// From t^n to t^n + dt. Collective. Errors: DivergedError.
  virtual void advance(System<Dim>& system, double dt) = 0;
};

/// The scheme named by -cloth_coupling.
template <int Dim>
std::unique_ptr<CouplingScheme<Dim>> make_coupling_scheme(const std::string& name);

}  // namespace washfsi
