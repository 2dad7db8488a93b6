// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/fluid/liquid.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

/// A flow as vectors on faces.
struct FlowState {
  Vec velocity;  ///< local, of face_dm, its ghosts filled [m/s]
  LiquidFields liquid;
  Vec fluid_fraction = nullptr;  ///< H of the faces; null: no solids
  double dry_fraction = 0;       ///< H up to which a face does not count as wet
};

/// Diagnostics after each step. Sums are over faces, weighted with H [in 2D per unit depth].
template <int Dim>
struct FlowDiagnostics {
  double kinetic_energy = 0;    ///< 1/2 sum rho |u|^2 [J]
  double angular_momentum = 0;  ///< sum rho (x u_y - y u_x), about the vertical (2D: point) in the box's middle [J s]
  double dissipation = 0;       ///< 2 mu e:e, e the rate of strain [W]
  double max_divergence = 0;    ///< [1/s]
  Located courant;              ///< largest dt sum_d |u_d|/h_d and its place; infinite where not finite

  /// Collective.
  static FlowDiagnostics of(const Grid<Dim>& grid, const FlowState& state, double dt);
};

extern template struct FlowDiagnostics<2>;
extern template struct FlowDiagnostics<3>;

}  // namespace washfsi
