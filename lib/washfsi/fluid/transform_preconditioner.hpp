// SPDX-License-Identifier: BSD-3-Clause
//
// Direct solution of the projection's equation for uniform density, -lap phi dx = r on the box with the cell volume dx,
// by fast transforms: cosine (DCT-II) along axes between boundaries, real Fourier along periodic axes. They make the
// 3-, 5- or 7-point Laplacian diagonal. Its eigenvalues are
//   sum_d (2 - 2 cos(pi k_d h_d / L_d)) / h_d^2,    with 2 pi in place of pi where periodic,
// with whole numbers k_d, for any number L_d/h_d of cells. phi is q~ of the theory (`pressure.hpp`).
// Each layout transforms its axes (`transform_layout.hpp`). After the last one, the coefficients are divided by the
// eigenvalues, and the transforms are undone in reverse order. The grid and the layouts exchange data by PetscSF built
// once.
#pragma once

#include <memory>
#include <vector>

#include <fftw3.h>

#include "washfsi/fluid/transform_layout.hpp"
#include "washfsi/grid/grid.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
class TransformSolver {
 public:
  /// Collective.
  explicit TransformSolver(const Grid<Dim>& grid)
      : TransformSolver(grid, transform_layouts<Dim>(grid.cells(), ranks_of(grid.comm()))) {}
  TransformSolver(const Grid<Dim>& grid, const TransformLayouts<Dim>& layouts);

  /// Sets phi to the solution with zero mean of -lap phi dx = r (r without its mean). Collective.
  void solve(Vec r, Vec phi);

 private:
  struct DestroyPlan {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };
  using Plan = std::unique_ptr<fftw_plan_s, DestroyPlan>;
  struct Free {
    void operator()(double* data) const { fftw_free(data); }
  };
  using Buffer = std::unique_ptr<double[], Free>;

  /// A layout with this rank's cells.
  struct Pass {
    TransformLayout<Dim> layout;
    Box<Dim> owned;
    std::size_t size;
    Buffer data;
    petsc::StarForest from_before;  ///< from the previous layout, or from the grid
    Plan forward, backward;
  };

  Pass pass(const TransformLayout<Dim>& layout) const;
  petsc::StarForest exchange(const Pass& to) const;
  PetscSFNode before(const Index<Dim>& cell) const;
  Plan plan(const Pass& pass, bool forward) const;
  void find_inverse_eigenvalues();

  const Grid<Dim>& grid_;
  std::vector<Pass> passes_;
  std::vector<double> inverse_eigenvalues_;  ///< inverse eigenvalues of the last pass's cells, times the transforms'
                                             ///< scale; 0 for the mean
};

/// Makes the solver known to PETSc as a preconditioner: -pressure_pc_type transform. Its DM must carry the Grid as
/// application context. Safe to call more than once.
void register_transform_preconditioner();

extern template class TransformSolver<2>;
extern template class TransformSolver<3>;

}  // namespace washfsi
