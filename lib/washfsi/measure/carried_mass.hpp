// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"

namespace washfsi {

/// Motion of the mass that the cloths carry themselves, as they do without fluid; zero where the water carries it.
struct CarriedMass {
  double kinetic_energy = 0;    ///< 1/2 sum m |V|^2 [J; J/m in the plane]
  double angular_momentum = 0;  ///< sum m (x v - y u), about the vertical through the middle of the box [J s; J s/m]

  /// Collective.
  template <int Dim>
  static CarriedMass of(const System<Dim>& system);
};

extern template CarriedMass CarriedMass::of<2>(const System<2>&);
extern template CarriedMass CarriedMass::of<3>(const System<3>&);

}  // namespace washfsi
