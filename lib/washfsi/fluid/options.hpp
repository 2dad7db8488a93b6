// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/fluid/driving.hpp"
#include "washfsi/fluid/liquid.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// The liquid and the numerics of its equations.
template <int Dim>
struct FluidOptions {
  double density = 1000;    ///< [kg/m3]
  double viscosity = 1e-3;  ///< dynamic [Pa s]
  ViscosityModels<Dim> viscosity_models;
  WallTreatment wall_model = WallTreatment::none;
  DrivingOptions<Dim> driving;
  std::string advection = "central";  ///< name of a scheme (`advection_scheme.hpp`)
  bool limits_at_edges = false;       ///< whether central advection becomes upwind by the nearness in a step's fields
  int advection_steps = 3;            ///< steps from which advection is extrapolated; 2: Adams-Bashforth (thesis)
  bool projection = true;             ///< false: the cloth tests of thesis 3.5.1, where u = u*
  double momentum_tolerance = 1e-7;   ///< rms residual of the momentum rows over the largest speed
  double pressure_tolerance = 5e-7;   ///< divergence left after a step over (largest speed)/h

  bool advects_centrally() const { return advection == "central"; }
  static FluidOptions from_options(Options& options);
};

extern template struct FluidOptions<2>;
extern template struct FluidOptions<3>;

}  // namespace washfsi
