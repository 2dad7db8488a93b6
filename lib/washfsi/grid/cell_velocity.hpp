// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/view.hpp"

namespace washfsi {

/// A component of the velocity in the middle of a cell [m/s].
template <int Dim, class Velocity>
[[gnu::always_inline]] inline double cell_velocity(const Velocity& u, const Index<Dim>& cell, int component) {
  return 0.5 * (u(cell, component) + u(shifted<Dim>(cell, component, 1), component));
}

}  // namespace washfsi
