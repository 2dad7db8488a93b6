// SPDX-License-Identifier: BSD-3-Clause
//
// Gradients of the velocity in the middle of cells, within one layer of ghosts.
#pragma once

#include "washfsi/grid/cell_velocity.hpp"
#include "washfsi/grid/stencils.hpp"

namespace washfsi {

template <int Dim>
using Gradient = Eigen::Matrix<double, Dim, Dim>;

/// du_c/dx_d in row c and column d [1/s]: differences across the cell on the diagonal, else central differences of the
/// velocities in the middles of the cells on either side.
template <int Dim, class Velocity>
[[gnu::always_inline]] inline Gradient<Dim> velocity_gradient(const Velocity& u, const Index<Dim>& cell,
                                                              const Spacing<Dim>& h) {
  Gradient<Dim> rate;
#pragma GCC unroll 3
  for (int d = 0; d < Dim; ++d) {
    const Index<Dim> above = shifted<Dim>(cell, d, 1), below = shifted<Dim>(cell, d, -1);
#pragma GCC unroll 3
    for (int c = 0; c < Dim; ++c)
      rate(c, d) = h.inverse[d] * (c == d ? u(above, d) - u(cell, d)
                                          : 0.5 * (cell_velocity<Dim>(u, above, c) - cell_velocity<Dim>(u, below, c)));
  }
  return rate;
}

}  // namespace washfsi
