// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// What is done beside the zero level of a level set that is reinitialised: `kept` holds it in place by Russo and
/// Smereka's subcell fix; `free` differences across it and lets it drift, as a baseline.
enum class ZeroLevel { kept, free };

/// Makes a level set on cells (global, of `cell_dm`) a signed distance [m] out to `reach` [m] from its zero level:
/// marches dPhi/dt* = sgn(Phi0) (1 - |grad Phi|) (4.2-1) in pseudo-time, upwind after Godunov and of first order away
/// from the zero level, which itself moves by O(h^2) only (Russo and Smereka, J. Comput. Phys. 163 (2000) 51).
/// Collective.
template <int Dim>
void reinitialise(const Grid<Dim>& grid, Vec level_set, double reach, ZeroLevel zero_level = ZeroLevel::kept);

extern template void reinitialise<2>(const Grid<2>&, Vec, double, ZeroLevel);
extern template void reinitialise<3>(const Grid<3>&, Vec, double, ZeroLevel);

}  // namespace washfsi
