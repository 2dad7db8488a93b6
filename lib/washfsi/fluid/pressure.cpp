// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "washfsi/fluid/pressure_multigrid.hpp"
#include "washfsi/fluid/transform_preconditioner.hpp"
#include "washfsi/grid/stencils.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/krylov.hpp"
#include "washfsi/support/vector_range.hpp"

namespace washfsi {

namespace {

constexpr const char* transform = "transform";  // the preconditioner that is the default

/// Assembles -div( ratio grad ) times the cell volume; ratio(cell, d) is that of the cell's lower d-face, 0 in the
/// boundary.
template <int Dim, class Ratio>
void assemble_laplacian(const Grid<Dim>& grid, Mat matrix, const Ratio& ratio) {
  const Point<Dim>& h = grid.spacing();
  const auto stencil_of = [](const Index<Dim>& cell) {
    MatStencil stencil{};
    stencil.i = cell[0];
    stencil.j = cell[1];
    if constexpr (Dim == 3) stencil.k = cell[2];
    return stencil;
  };
  WASH_PETSC(MatZeroEntries(matrix));
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    const MatStencil row = stencil_of(cell);
    std::array<MatStencil, 2 * Dim + 1> columns{row};
    std::array<double, 2 * Dim + 1> values{};
    PetscInt used = 1;
    for (int d = 0; d < Dim; ++d)
      for (const int step : {-1, 1}) {
        const Index<Dim> neighbour = shifted<Dim>(cell, d, step);
        const double weight = h.prod() * ratio(step < 0 ? cell : neighbour, d) / (h[d] * h[d]);
        if (weight == 0) continue;
        columns[used] = stencil_of(neighbour);
        values[used++] = -weight;
        values[0] += weight;
      }
    WASH_PETSC(MatSetValuesStencil(matrix, 1, &row, used, columns.data(), values.data(), ADD_VALUES));
  });
  WASH_PETSC(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
  WASH_PETSC(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
}

}  // namespace

template <int Dim>
PressureSolver<Dim>::PressureSolver(const Grid<Dim>& grid) : grid_(grid) {
  WASH_PETSC(DMCreateLocalVector(grid.stencil_dm(), local_phi_.put()));
  WASH_PETSC(VecZeroEntries(local_phi_));
  create_matrices();

  WASH_PETSC(KSPCreate(grid.comm(), solver_.put()));
  WASH_PETSC(KSPSetOptionsPrefix(solver_, "pressure_"));
  WASH_PETSC(KSPSetType(solver_, KSPCG));
  WASH_PETSC(KSPSetNormType(solver_, KSP_NORM_UNPRECONDITIONED));
  WASH_PETSC(KSPSetInitialGuessNonzero(solver_, PETSC_TRUE));
  // no divergence test against the right side: with a good guess it may be far smaller than the first residual
  WASH_PETSC(KSPSetTolerances(solver_, 1e-50, PETSC_DEFAULT, 1e50, 1000));
  WASH_PETSC(KSPSetOperators(solver_, matrix_, assembled_ ? assembled_ : matrix_));
  PC pc = nullptr;
  WASH_PETSC(KSPGetPC(solver_, &pc));
  WASH_PETSC(PCSetDM(pc, grid.stencil_dm()));
  register_transform_preconditioner();
  WASH_PETSC(PCSetType(pc, transform));
  solves_directly_ = !assembled_ && options_with_prefix("pressure_ksp_").empty();
  const petsc::Vector uniform = grid.face_vector();
  WASH_PETSC(VecSet(uniform, reference_density_));
  set_density(uniform);
  set_preconditioner_defaults();
  user_sets_atol_ = set_up_from_options(solver_);
}

// The transform needs no assembled matrix; an unknown matrix type is refused all the same.
template <int Dim>
void PressureSolver<Dim>::create_matrices() {
  WASH_PETSC(MatNullSpaceCreate(grid_.comm(), PETSC_TRUE, 0, nullptr, constants_.put()));
  const auto size = static_cast<PetscInt>(grid_.owned().count());
  WASH_PETSC(MatCreateShell(grid_.comm(), size, size, PETSC_DETERMINE, PETSC_DETERMINE, this, matrix_.put()));
  WASH_PETSC(MatShellSetOperation(matrix_, MATOP_MULT, reinterpret_cast<void (*)()>(&PressureSolver::multiply)));
  WASH_PETSC(MatSetNullSpace(matrix_, constants_));
  if (petsc::option_value("pressure_", "-pc_type", transform) == transform) {
    petsc::Matrix without_entries;
    WASH_PETSC(MatCreate(grid_.comm(), without_entries.put()));
    WASH_PETSC(MatSetFromOptions(without_entries));
    return;
  }
  WASH_PETSC(DMCreateMatrix(grid_.stencil_dm(), assembled_.put()));
  WASH_PETSC(MatSetNullSpace(assembled_, constants_));
  WASH_PETSC(MatSetOption(assembled_, MAT_SPD, PETSC_TRUE));
}

// Sets what hypre and PCMG read from the options database only.
template <int Dim>
void PressureSolver<Dim>::set_preconditioner_defaults() {
  const std::string chosen = petsc::option_value("pressure_", "-pc_type", "");
  if (chosen == PCHYPRE) {
    petsc::set_default_option("-pressure_pc_hypre_type", "boomeramg");
    // its own choice, Gaussian elimination, fails on the singular matrix
    petsc::set_default_option("-pressure_pc_hypre_boomeramg_relax_type_coarse", "symmetric-SOR/Jacobi");
  }
  if (chosen == PCGAMG) petsc::set_default_option("-pressure_mg_coarse_sub_pc_type", "svd");
  if (chosen == PCMG) {
    PC pc = nullptr;
    WASH_PETSC(KSPGetPC(solver_, &pc));
    set_up_multigrid(grid_, pc);
  }
}

template <int Dim>
void PressureSolver<Dim>::set_density(Vec density, Vec fluid_fraction) {
  const std::array versions{petsc::Version(density), petsc::Version(fluid_fraction)};
  if (versions == versions_) return;
  versions_ = versions;
  const VectorRange densities = range_of(density);
  reference_density_ = densities.least;
  is_uniform_ = !fluid_fraction && densities.is_uniform();
  if (is_direct()) return;
  const bool nearly_uniform = find_ratio(density, fluid_fraction);
  if (!assembled_) return;
  // If the density is nearly uniform, the preconditioner for uniform density is kept; otherwise it is assembled in each
  // step. The choice depends on this step's density alone, so that a restarted run makes the same one.
  if (nearly_uniform && assembled_is_uniform_) return;
  assembled_is_uniform_ = nearly_uniform;
  assemble();
}

// Whether the density is nearly the same everywhere.
template <int Dim>
bool PressureSolver<Dim>::find_ratio(Vec density, Vec fluid_fraction) {
  constexpr double least_fraction = 1e-2;  // so that the equation stays solvable within solids
  const petsc::GlobalVector inner(grid_.face_dm());
  {
    const FaceView<Dim> ratio(grid_.face_dm(), inner);
    const ConstFaceView<Dim> rho(grid_.face_dm(), density),
        fraction(grid_.face_dm(), fluid_fraction ? fluid_fraction : density);
    const bool variable = fluid_fraction != nullptr;
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
      for (int d = 0; d < Dim; ++d)
        ratio(face, d) =
            (variable ? std::max(fraction(face, d), least_fraction) : 1) * reference_density_ / rho(face, d);
    });
  }
  if (!ratio_) WASH_PETSC(DMCreateLocalVector(grid_.face_dm(), ratio_.put()));
  WASH_PETSC(DMGlobalToLocal(grid_.face_dm(), inner, INSERT_VALUES, ratio_));
  close_boundary_faces();
  const VectorRange ratios = range_of(inner);
  return ratios.least > 1 / 1.5 && ratios.most < 1.5;
}

// Sets the ratio on boundary faces to 0: no flux through the sides of the box.
template <int Dim>
void PressureSolver<Dim>::close_boundary_faces() {
  const FaceView<Dim> ratio(grid_.face_dm(), ratio_);
  for (int d = 0; d < Dim; ++d) {
    if (grid_.periodic(d)) continue;
    Box<Dim> faces = grid_.owned();
    ++faces.upper[d];  // the upper faces of the last owned cells
    for_each<Dim>(faces, [&](const Index<Dim>& face) {
      if (face[d] == 0 || face[d] == grid_.cells()[d]) ratio(face, d) = 0;
    });
  }
}

template <int Dim>
void PressureSolver<Dim>::assemble() {
  const ConstFaceView<Dim> ratio(grid_.face_dm(), ratio_);
  const bool uniform = assembled_is_uniform_;
  assemble_laplacian<Dim>(grid_, assembled_, [&](const Index<Dim>& face, int d) {
    const double value = ratio(face, d);
    return uniform && value != 0 ? 1.0 : value;
  });
  WASH_PETSC(KSPSetOperators(solver_, matrix_, assembled_));
}

template <int Dim>
PetscErrorCode PressureSolver<Dim>::multiply(Mat matrix, Vec x, Vec y) {
  return petsc::guarded([&] {
    void* self = nullptr;
    WASH_PETSC(MatShellGetContext(matrix, &self));
    static_cast<PressureSolver*>(self)->apply(x, y);
  });
}

template <int Dim>
void PressureSolver<Dim>::apply(Vec x, Vec y) {
  WASH_PETSC(DMGlobalToLocal(grid_.stencil_dm(), x, INSERT_VALUES, local_phi_));
  const ConstCellView<Dim> phi(grid_.stencil_dm(), local_phi_);
  const ConstFaceView<Dim> ratio(grid_.face_dm(), ratio_);
  const CellView<Dim> result(grid_.stencil_dm(), y);
  const Point<Dim> weight = grid_.cell_volume() * grid_.spacing().cwiseProduct(grid_.spacing()).cwiseInverse();
  for_each<Dim>(grid_.owned(), [&](const Index<Dim>& cell) {
    double sum = 0;
    for (int d = 0; d < Dim; ++d) {
      const Index<Dim> next = shifted<Dim>(cell, d, 1);
      sum += weight[d] *
             (ratio(cell, d) * (phi(cell) - phi(shifted<Dim>(cell, d, -1))) - ratio(next, d) * (phi(next) - phi(cell)));
    }
    result(cell) = sum;
  });
}

// With uniform density the transform is exact (`TransformSolver::solve`): nothing is left for CG.
template <int Dim>
void PressureSolver<Dim>::solve_directly(Vec minus_divergence, Vec phi) const {
  PC pc = nullptr;
  WASH_PETSC(KSPGetPC(solver_, &pc));
  WASH_PETSC(PCApply(pc, minus_divergence, phi));
  double size = 0;
  WASH_PETSC(VecNorm(phi, NORM_2, &size));
  if (!std::isfinite(size)) throw DivergedError("pressure: the right side is not finite");
}

template <int Dim>
PetscInt PressureSolver<Dim>::solve(Vec minus_divergence, double tolerance, Vec phi) {
  const double volume = grid_.cell_volume();
  WASH_PETSC(VecScale(minus_divergence, volume));
  if (is_direct()) {
    solve_directly(minus_divergence, phi);
    return 1;
  }
  return solve_to(solver_, user_sets_atol_ ? 0 : std::max(volume * tolerance, 1e-300), minus_divergence, phi,
                  "pressure");
}

template <int Dim>
template <class Ratio>
void PressureSolver<Dim>::correct_by(const Ratio& ratio, Vec phi, Vec velocity) const {
  WASH_PETSC(DMGlobalToLocal(grid_.stencil_dm(), phi, INSERT_VALUES, local_phi_));
  const ConstCellView<Dim> local(grid_.stencil_dm(), local_phi_);
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  const Spacing<Dim> h(grid_.spacing());
  grid_.for_each_inner_face(
      [&](const Index<Dim>& face, auto d) { u(face, d) -= ratio(face, d) * gradient<Dim>(local, face, d, h); });
}

template <int Dim>
void PressureSolver<Dim>::correct(Vec phi, Vec velocity) const {
  if (is_uniform_)
    correct_by([](const Index<Dim>&, int) { return 1; }, phi, velocity);
  else
    correct_by(ConstFaceView<Dim>(grid_.face_dm(), ratio_), phi, velocity);
}

template class PressureSolver<2>;
template class PressureSolver<3>;

}  // namespace washfsi
