// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/pressure_multigrid.hpp"

#include <cstdlib>
#include <string>

#include "washfsi/fluid/cell_levels.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/krylov.hpp"

namespace washfsi {

namespace {

constexpr double coarsest_cells = 64;    // a level with at most this many cells is the last
constexpr double most_for_dense = 1000;  // cells of a coarsest level that is solved by singular value decomposition

/// All levels, the finest first. The user may request fewer than possible.
template <int Dim>
std::vector<CellLevel<Dim>> levels_of(const Grid<Dim>& grid) {
  refuse_deadly_options("pressure_");
  const std::string given = petsc::option_value("pressure_", "-pc_mg_levels", "");
  const auto wanted = static_cast<std::size_t>(std::strtod(given.c_str(), nullptr));  // 0 without the option
  std::vector<CellLevel<Dim>> levels{CellLevel<Dim>(grid)};
  while (levels.back().cell_count() > coarsest_cells && levels.size() != wanted)
    levels.push_back(levels.back().coarsened());
  if (wanted > levels.size())
    throw InputError("-pressure_pc_mg_levels " + given + ": this grid has at most " + std::to_string(levels.size()) +
                     " levels");
  return levels;
}

/// The linear interpolation from the middles of coarse cells to those of fine ones.
template <int Dim>
petsc::Matrix interpolation(MPI_Comm comm, const CellLevel<Dim>& fine, const CellLevel<Dim>& coarse) {
  constexpr PetscInt corners = 1 << Dim;
  const int rank = rank_of(comm);
  petsc::Matrix matrix;
  WASH_PETSC(MatCreateAIJ(comm, fine.count(rank), coarse.count(rank), PETSC_DETERMINE, PETSC_DETERMINE, corners,
                          nullptr, corners, nullptr, matrix.put()));
  for_each<Dim>(fine.owned_by(rank), [&](const Index<Dim>& cell) {
    std::array<CellLine::Place, Dim> places;
    for (int d = 0; d < Dim; ++d) places[d] = coarse.line(d).place(fine.line(d).middle(cell[d]));
    for (PetscInt corner = 0; corner < corners; ++corner) {
      Index<Dim> from;
      double weight = 1;
      for (int d = 0; d < Dim; ++d) {
        const PetscInt side = corner >> d & 1;
        from[d] = places[d].cells[side];
        weight *= places[d].weights[side];
      }
      if (weight != 0) WASH_PETSC(MatSetValue(matrix, fine.number(cell), coarse.number(from), weight, ADD_VALUES));
    }
  });
  WASH_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
  return matrix;
}

// Half of the work of PETSc's own choice, Chebyshev's method with two symmetric sweeps, and as few iterations.
void smooth_by_one_sweep(PC pc, PetscInt level) {
  KSP smoother = nullptr;
  WASH_PETSC(PCMGGetSmoother(pc, level, &smoother));
  WASH_PETSC(KSPSetType(smoother, KSPRICHARDSON));
  WASH_PETSC(KSPSetTolerances(smoother, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT, 1));
}

// The matrix of the coarsest level is singular as well.
void set_coarsest_defaults(double cells) {
  const bool dense = cells <= most_for_dense;
  petsc::set_default_option("-pressure_mg_coarse_pc_type", dense ? "redundant" : "sor");
  if (dense) petsc::set_default_option("-pressure_mg_coarse_redundant_pc_type", "svd");
}

}  // namespace

template <int Dim>
void set_up_multigrid(const Grid<Dim>& grid, PC pc) {
  const std::vector<CellLevel<Dim>> levels = levels_of(grid);
  const auto finest = static_cast<PetscInt>(levels.size()) - 1;  // PETSc counts from the coarsest
  WASH_PETSC(PCSetType(pc, PCMG));
  WASH_PETSC(PCSetUseAmat(pc, PETSC_FALSE));  // PCMG would take the operator without entries for the finest level
  WASH_PETSC(PCMGSetLevels(pc, finest + 1, nullptr));
  WASH_PETSC(PCMGSetGalerkin(pc, PC_MG_GALERKIN_BOTH));
  for (PetscInt level = finest; level > 0; --level) {
    const std::size_t fine = finest - level;
    WASH_PETSC(PCMGSetInterpolation(pc, level, interpolation(grid.comm(), levels[fine], levels[fine + 1])));
    if (!petsc::option_given("pressure_", "-mg_levels_ksp_type")) smooth_by_one_sweep(pc, level);
  }
  if (finest > 0) set_coarsest_defaults(levels.back().cell_count());
}

template void set_up_multigrid<2>(const Grid<2>& grid, PC pc);
template void set_up_multigrid<3>(const Grid<3>& grid, PC pc);

}  // namespace washfsi
