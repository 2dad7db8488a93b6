// SPDX-License-Identifier: BSD-3-Clause
//
// Direct solve of the projection's equation for uniform density, -lap phi times cell volume = r on the box, by fast
// transforms: cosine (DCT-II) along directions between boundaries, real Fourier along periodic ones. In their basis the
// 3-, 5- or 7-point Laplacian is diagonal,  lambda = sum_d (2 - 2 cos(pi k_d / n_d)) / h_d^2  (2 pi k_d / n_d when
// periodic), for any n_d.
//   1. slabs:     cut along the last axis;       transform all other axes in one batch
//   2. columns:   cut along the last but one;    transform the last axis, divide by lambda, transform back
//   3. slabs:     transform the other axes back
// The three layouts (grid, slabs, columns) exchange data by two PetscSF built once.
#pragma once

#include <memory>
#include <vector>

#include <fftw3.h>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

template <int Dim>
class TransformSolver {
 public:
  /// Collective.
  explicit TransformSolver(const Grid<Dim>& grid);

  /// phi = the solution of zero mean of -lap phi = r (r without its mean). Collective.
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

  void build_exchanges();
  void build_plans();
  void build_inverse_eigenvalues();
  std::vector<fftw_r2r_kind> kinds(int first_axis, int last_axis, bool forward) const;
  Index<Dim> column_index(std::size_t entry) const;

  const Grid<Dim>& grid_;
  std::vector<PetscInt> slab_starts_, column_starts_;  ///< first layer of each rank, and the end
  std::size_t slab_size_ = 0, column_size_ = 0;
  PetscInt slab_layers_ = 0, column_layers_ = 0;
  Buffer slab_, columns_;
  petsc::StarForest grid_to_slab_, slab_to_columns_;
  Plan slab_forward_, slab_backward_, columns_forward_, columns_backward_;
  std::vector<double> inverse_eigenvalues_;  ///< of the columns' entries, with the transforms' scale; 0 for the mean
};

/// Makes the solver known to PETSc as a preconditioner: -pressure_pc_type transform. Its DM must carry the Grid as
/// application context. Safe to call more than once.
void register_transform_preconditioner();

extern template class TransformSolver<2>;
extern template class TransformSolver<3>;

}  // namespace washfsi
