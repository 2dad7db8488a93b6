// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

/// A liquid without what models add to its viscosity, and without the mass of cloth: the same everywhere.
struct PureLiquid {
  double density, viscosity;  ///< [kg/m3], dynamic [Pa s]
};

}  // namespace washfsi
