// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/transform_preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
TransformSolver<Dim>::TransformSolver(const Grid<Dim>& grid, const TransformLayouts<Dim>& layouts) : grid_(grid) {
  for (const auto& layout : layouts) passes_.push_back(pass(layout));
  find_inverse_eigenvalues();
}

template <int Dim>
typename TransformSolver<Dim>::Pass TransformSolver<Dim>::pass(const TransformLayout<Dim>& layout) const {
  const Box<Dim> owned = layout.owned_by(rank_of(grid_.comm()));
  Pass pass{layout, owned, owned.count(), {}, {}, {}, {}};
  pass.data.reset(fftw_alloc_real(std::max<std::size_t>(pass.size, 1)));
  pass.from_before = exchange(pass);
  pass.forward = plan(pass, true);
  pass.backward = plan(pass, false);
  return pass;
}

// The place of a cell of the next layout in the previous one, or in the grid.
template <int Dim>
PetscSFNode TransformSolver<Dim>::before(const Index<Dim>& cell) const {
  if (!passes_.empty()) {
    const TransformLayout<Dim>& layout = passes_.back().layout;
    const int rank = layout.owner(cell);
    return {rank, layout.offset(layout.owned_by(rank), cell)};
  }
  TransformLayout<Dim> of_vectors{};
  std::iota(of_vectors.order.begin(), of_vectors.order.end(), 0);
  const int rank = grid_.owner(cell);
  return {rank, of_vectors.offset(grid_.owned_by(rank), cell)};
}

template <int Dim>
petsc::StarForest TransformSolver<Dim>::exchange(const Pass& to) const {
  std::vector<PetscSFNode> sources;
  sources.reserve(to.size);
  for (std::size_t entry = 0; entry < to.size; ++entry)
    sources.push_back(before(to.layout.cell(to.owned, static_cast<PetscInt>(entry))));
  return petsc::star_forest(grid_.comm(), passes_.empty() ? grid_.owned().count() : passes_.back().size, sources);
}

// Estimated plans are the same in every run, measured ones are not: results must repeat to the bit.
template <int Dim>
typename TransformSolver<Dim>::Plan TransformSolver<Dim>::plan(const Pass& pass, bool forward) const {
  std::vector<int> lengths;  // FFTW expects the slowest first
  std::vector<fftw_r2r_kind> kinds;
  int distance = 1;
  for (int i = pass.layout.transformed; i-- > 0;) {
    const int axis = pass.layout.order[i];
    lengths.push_back(static_cast<int>(grid_.cells()[axis]));
    kinds.push_back(grid_.periodic(axis) ? (forward ? FFTW_R2HC : FFTW_HC2R) : (forward ? FFTW_REDFT10 : FFTW_REDFT01));
    distance *= lengths.back();
  }
  const int count = static_cast<int>(pass.size) / distance;
  return Plan(fftw_plan_many_r2r(pass.layout.transformed, lengths.data(), count, pass.data.get(), nullptr, 1, distance,
                                 pass.data.get(), nullptr, 1, distance, kinds.data(), FFTW_ESTIMATE));
}

template <int Dim>
void TransformSolver<Dim>::find_inverse_eigenvalues() {
  const Pass& last = passes_.back();
  double scale = grid_.cell_volume();  // FFTW's transforms there and back multiply by 2 n (cosine) or n (Fourier)
  for (int d = 0; d < Dim; ++d) scale *= static_cast<double>(grid_.cells()[d]) * (grid_.periodic(d) ? 1 : 2);
  inverse_eigenvalues_.resize(last.size);
  for (std::size_t entry = 0; entry < last.size; ++entry) {
    const Index<Dim> mode = last.layout.cell(last.owned, static_cast<PetscInt>(entry));
    double eigenvalue = 0;
    for (int d = 0; d < Dim; ++d) {
      const double turns = (grid_.periodic(d) ? 2.0 : 1.0) * static_cast<double>(mode[d]);
      const double angle = std::numbers::pi * turns / static_cast<double>(grid_.cells()[d]);
      eigenvalue += (2 - 2 * std::cos(angle)) / (grid_.spacing()[d] * grid_.spacing()[d]);
    }
    const bool mean = std::all_of(mode.begin(), mode.end(), [](PetscInt k) { return k == 0; });
    inverse_eigenvalues_[entry] = mean ? 0 : 1 / (eigenvalue * scale);
  }
}

template <int Dim>
void TransformSolver<Dim>::solve(Vec r, Vec phi) {
  const double* input = nullptr;
  WASH_PETSC(VecGetArrayRead(r, &input));
  const double* before = input;
  for (const Pass& pass : passes_) {
    WASH_PETSC(PetscSFBcastBegin(pass.from_before, MPI_DOUBLE, before, pass.data.get(), MPI_REPLACE));
    WASH_PETSC(PetscSFBcastEnd(pass.from_before, MPI_DOUBLE, before, pass.data.get(), MPI_REPLACE));
    if (pass.forward) fftw_execute(pass.forward.get());
    before = pass.data.get();
  }
  WASH_PETSC(VecRestoreArrayRead(r, &input));
  double* last = passes_.back().data.get();
  for (std::size_t entry = 0; entry < inverse_eigenvalues_.size(); ++entry) last[entry] *= inverse_eigenvalues_[entry];
  double* output = nullptr;
  WASH_PETSC(VecGetArray(phi, &output));
  for (std::size_t n = passes_.size(); n-- > 0;) {
    const Pass& pass = passes_[n];
    double* target = n == 0 ? output : passes_[n - 1].data.get();
    if (pass.backward) fftw_execute(pass.backward.get());
    WASH_PETSC(PetscSFReduceBegin(pass.from_before, MPI_DOUBLE, pass.data.get(), target, MPI_REPLACE));
    WASH_PETSC(PetscSFReduceEnd(pass.from_before, MPI_DOUBLE, pass.data.get(), target, MPI_REPLACE));
  }
  WASH_PETSC(VecRestoreArray(phi, &output));
}

template class TransformSolver<2>;
template class TransformSolver<3>;

namespace {

/// The solver of either dimension behind one PETSc preconditioner.
struct TransformContext {
  std::unique_ptr<TransformSolver<2>> plane;
  std::unique_ptr<TransformSolver<3>> space;
};

PetscErrorCode transform_set_up(PC pc) {
  return petsc::guarded([&] {
    TransformContext* context = nullptr;
    WASH_PETSC(PCShellGetContext(pc, &context));
    if (context->plane || context->space) return;
    DM dm = nullptr;
    void* grid = nullptr;
    PetscInt dimension = 0;
    WASH_PETSC(PCGetDM(pc, &dm));
    WASH_PETSC(DMGetApplicationContext(dm, &grid));
    WASH_PETSC(DMGetDimension(dm, &dimension));
    if (dimension == 2)
      context->plane = std::make_unique<TransformSolver<2>>(*static_cast<const Grid<2>*>(grid));
    else
      context->space = std::make_unique<TransformSolver<3>>(*static_cast<const Grid<3>*>(grid));
  });
}

PetscErrorCode transform_apply(PC pc, Vec r, Vec phi) {
  return petsc::guarded([&] {
    TransformContext* context = nullptr;
    WASH_PETSC(PCShellGetContext(pc, &context));
    if (context->plane)
      context->plane->solve(r, phi);
    else
      context->space->solve(r, phi);
  });
}

PetscErrorCode transform_destroy(PC pc) {
  return petsc::guarded([&] {
    TransformContext* context = nullptr;
    WASH_PETSC(PCShellGetContext(pc, &context));
    delete context;
  });
}

PetscErrorCode transform_create(PC pc) {
  return petsc::guarded([&] {
    WASH_PETSC(PCSetType(pc, PCSHELL));
    WASH_PETSC(PCShellSetName(pc, "transform"));
    WASH_PETSC(PCShellSetContext(pc, new TransformContext));
    WASH_PETSC(PCShellSetSetUp(pc, transform_set_up));
    WASH_PETSC(PCShellSetApply(pc, transform_apply));
    WASH_PETSC(PCShellSetDestroy(pc, transform_destroy));
  });
}

}  // namespace

void register_transform_preconditioner() {
  WASH_PETSC(PCRegister("transform", transform_create));
}

}  // namespace washfsi
