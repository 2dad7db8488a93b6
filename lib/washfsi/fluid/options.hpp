// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// The liquid and how its equations are advanced.
template <int Dim>
struct FluidOptions {
  double density = 1000;         ///< [kg/m3]
  double viscosity = 1e-3;       ///< dynamic [Pa s]
  std::string initial = "rest";  ///< rest | taylor_green | couette (set by who knows the bodies) | uniform
  Point<Dim> initial_velocity = Point<Dim>::Zero();  ///< of `uniform` [m/s]
  std::string advection = "central";                 ///< central | wide_central | upwind
  bool projection = true;                            ///< false: the cloth tests of thesis 3.5.1, where u = u*
  double momentum_tolerance = 1e-7;  ///< rms residual of the momentum rows, as a part of the largest speed
  double pressure_tolerance = 5e-7;  ///< divergence left after a step, as a part of (largest speed)/h

  static FluidOptions from_options(Options& options);
};

extern template struct FluidOptions<2>;
extern template struct FluidOptions<3>;

}  // namespace washfsi
