// SPDX-License-Identifier: BSD-3-Clause
//
// Rates of strain where the staggered grid has them: stretching in cells, shear on the edges where two faces meet.
#pragma once

#include "washfsi/grid/stencils.hpp"

namespace washfsi {

/// du_c/dx_c in a cell [1/s].
template <int Dim, class Velocity>
[[gnu::always_inline]] inline double stretching(const Velocity& u, const Index<Dim>& cell, int c,
                                                const Spacing<Dim>& h) {
  return (u(shifted<Dim>(cell, c, 1), c) - u(cell, c)) * h.inverse[c];
}

/// du_c/dx_d + du_d/dx_c on edge (index, c, d), where the lower c-face and the lower d-face of a cell meet [1/s].
template <int Dim, class Velocity>
[[gnu::always_inline]] inline double shear_rate(const Velocity& u, const Index<Dim>& edge, int c, int d,
                                                const Spacing<Dim>& h) {
  return (u(edge, c) - u(shifted<Dim>(edge, d, -1), c)) * h.inverse[d] +
         (u(edge, d) - u(shifted<Dim>(edge, c, -1), d)) * h.inverse[c];
}

}  // namespace washfsi
