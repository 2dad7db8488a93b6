// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "washfsi/simulation/step_bound.hpp"
#include "washfsi/simulation/system.hpp"

namespace washfsi {

/// How cloth and water are coupled in a step.
struct CouplingOptions {
  std::string scheme = "semi_implicit";     ///< explicit | midpoint | semi_implicit | implicit; not for one alone
  bool scheme_given = false;                ///< by the user
  std::string time_scheme = "trapezoidal";  ///< of the implicit coupling: trapezoidal | backward_euler
  std::string mobility = "matrix";          ///< that stands for the markers' own (semi_implicit): matrix | row_sums
  double mobility_factor = 1;               ///< of it
  double tolerance = 1e-5;                  ///< rms residual of the markers' velocities over the flow's speed
  PetscInt sweeps = 1;                      ///< at most, of the semi-implicit coupling
  double slip_tolerance = 0.01;             ///< below which no further sweep is made

  static CouplingOptions from_options(Options& options);
};

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
  /// Longest step for the cloth as it lies now [s]: that of the explicit coupling unless overridden. Collective.
  virtual double step_bound(const System<Dim>& system) const { return cloth_step_bound<Dim>(system); }
};

/// The scheme for a system. Errors: InputError if it does not fit the cloths.
template <int Dim>
std::unique_ptr<CouplingScheme<Dim>> make_coupling_scheme(const CouplingOptions& options, const System<Dim>& system);

}  // namespace washfsi
