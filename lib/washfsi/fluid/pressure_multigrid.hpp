// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// Sets a preconditioner of the pressure's matrix up as geometric multigrid, for any number of cells and ranks: PETSc's
/// PCMG with linear interpolation between the cells of `CellLevel`, its transpose as restriction, and coarse matrices
/// that PETSc makes by Galerkin's products of the matrix, so that they see its densities. The V-cycle is symmetric: one
/// symmetric sweep of SOR before and after. All of it yields to -pressure_pc_mg_ and -pressure_mg_ options.
/// Collective. Errors: InputError.
template <int Dim>
void set_up_multigrid(const Grid<Dim>& grid, PC pc);

extern template void set_up_multigrid<2>(const Grid<2>& grid, PC pc);
extern template void set_up_multigrid<3>(const Grid<3>& grid, PC pc);

}  // namespace washfsi
