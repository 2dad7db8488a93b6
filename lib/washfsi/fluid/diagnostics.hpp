// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

/// What is watched after each step. `velocity` is global, at `time`.
template <int Dim>
struct FlowDiagnostics {
  double kinetic_energy = 0;  ///< 1/2 sum rho |u|^2 over faces [J; in 2D J/m]
  double max_divergence = 0;  ///< [1/s]
  Located courant;            ///< largest dt sum_d |u_d|/h_d and its place; infinite where not finite

  /// Collective.
  static FlowDiagnostics of(const Grid<Dim>& grid, const Boundary<Dim>& boundary, Vec velocity, Vec density,
                            double time, double dt);
};

extern template struct FlowDiagnostics<2>;
extern template struct FlowDiagnostics<3>;

}  // namespace washfsi
