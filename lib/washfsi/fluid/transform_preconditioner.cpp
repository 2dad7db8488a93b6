// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/transform_preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

// n layers over the ranks, as even as can be.
std::vector<PetscInt> even_starts(PetscInt n, int ranks) {
  std::vector<PetscInt> starts;
  for (int rank = 0; rank <= ranks; ++rank) starts.push_back(n * rank / ranks);
  return starts;
}

int owner_of(const std::vector<PetscInt>& starts, PetscInt layer) {
  return static_cast<int>(std::upper_bound(starts.begin(), starts.end(), layer) - starts.begin()) - 1;
}

template <int Dim>
std::size_t volume(const Box<Dim>& box) {
  std::size_t count = 1;
  for (int d = 0; d < Dim; ++d) count *= static_cast<std::size_t>(box.upper[d] - box.lower[d]);
  return count;
}

// Place of an index in an array over a box, x fastest.
template <int Dim>
PetscInt offset_in(const Box<Dim>& box, const Index<Dim>& index) {
  PetscInt offset = 0;
  for (int d = Dim; d-- > 0;) offset = offset * (box.upper[d] - box.lower[d]) + index[d] - box.lower[d];
  return offset;
}

}  // namespace

template <int Dim>
TransformSolver<Dim>::TransformSolver(const Grid<Dim>& grid) : grid_(grid) {
  const int ranks = ranks_of(grid.comm()), rank = rank_of(grid.comm());
  slab_starts_ = even_starts(grid.cells()[Dim - 1], ranks);
  column_starts_ = even_starts(grid.cells()[Dim - 2], ranks);
  const auto own = static_cast<std::size_t>(rank);
  slab_layers_ = slab_starts_[own + 1] - slab_starts_[own];
  column_layers_ = column_starts_[own + 1] - column_starts_[own];
  const auto all = static_cast<std::size_t>(grid.cell_count());
  slab_size_ = all / static_cast<std::size_t>(grid.cells()[Dim - 1]) * static_cast<std::size_t>(slab_layers_);
  column_size_ = all / static_cast<std::size_t>(grid.cells()[Dim - 2]) * static_cast<std::size_t>(column_layers_);
  slab_.reset(fftw_alloc_real(std::max<std::size_t>(slab_size_, 1)));
  columns_.reset(fftw_alloc_real(std::max<std::size_t>(column_size_, 1)));
  build_exchanges();
  build_plans();
  build_inverse_eigenvalues();
}

// The cell of an entry of the columns array: last axis fastest, then the others but the cut one, which is slowest.
template <int Dim>
Index<Dim> TransformSolver<Dim>::column_index(std::size_t entry) const {
  Index<Dim> index{};
  auto rest = static_cast<PetscInt>(entry);
  const auto take = [&](std::size_t axis) {
    index[axis] = rest % grid_.cells()[axis];
    rest /= grid_.cells()[axis];
  };
  take(Dim - 1);
  if constexpr (Dim == 3) take(0);
  index[Dim - 2] = rest + column_starts_[static_cast<std::size_t>(rank_of(grid_.comm()))];
  return index;
}

template <int Dim>
void TransformSolver<Dim>::build_exchanges() {
  Box<Dim> whole{};
  for (int d = 0; d < Dim; ++d) whole.upper[d] = grid_.cells()[d];
  const auto slab_of = [&](int rank) {
    Box<Dim> box = whole;
    box.lower[Dim - 1] = slab_starts_[rank];
    box.upper[Dim - 1] = slab_starts_[static_cast<std::size_t>(rank) + 1];
    return box;
  };
  std::vector<PetscSFNode> sources;
  for_each<Dim>(slab_of(rank_of(grid_.comm())), [&](const Index<Dim>& cell) {
    const int rank = grid_.owner(cell);
    sources.push_back({rank, offset_in<Dim>(grid_.owned_by(rank), cell)});
  });
  grid_to_slab_ = petsc::star_forest(grid_.comm(), volume<Dim>(grid_.owned()), sources);

  sources.clear();
  for (std::size_t entry = 0; entry < column_size_; ++entry) {
    const Index<Dim> cell = column_index(entry);
    const int rank = owner_of(slab_starts_, cell[Dim - 1]);
    sources.push_back({rank, offset_in<Dim>(slab_of(rank), cell)});
  }
  slab_to_columns_ = petsc::star_forest(grid_.comm(), slab_size_, sources);
}

// FFTW's kinds for the axes last_axis..first_axis (slowest first).
template <int Dim>
std::vector<fftw_r2r_kind> TransformSolver<Dim>::kinds(int first_axis, int last_axis, bool forward) const {
  std::vector<fftw_r2r_kind> result;
  for (int d = last_axis; d >= first_axis; --d)
    result.push_back(grid_.periodic(d) ? (forward ? FFTW_R2HC : FFTW_HC2R) : (forward ? FFTW_REDFT10 : FFTW_REDFT01));
  return result;
}

template <int Dim>
void TransformSolver<Dim>::build_plans() {
  std::vector<int> slab_shape;
  for (std::size_t d = Dim - 1; d-- > 0;) slab_shape.push_back(static_cast<int>(grid_.cells()[d]));
  const int layer = static_cast<int>(grid_.cell_count()) / static_cast<int>(grid_.cells()[Dim - 1]);
  const int length = static_cast<int>(grid_.cells()[Dim - 1]);
  const int columns = static_cast<int>(column_size_) / length;
  const auto batch = [](double* data, const std::vector<int>& shape, int count, int stride,
                        const std::vector<fftw_r2r_kind>& kind) {
    // estimated plans are the same in every run, measured ones are not: results must repeat to the bit
    return Plan(fftw_plan_many_r2r(static_cast<int>(shape.size()), shape.data(), count, data, nullptr, 1, stride, data,
                                   nullptr, 1, stride, kind.data(), FFTW_ESTIMATE));
  };
  const int slabs = static_cast<int>(slab_layers_);
  slab_forward_ = batch(slab_.get(), slab_shape, slabs, layer, kinds(0, Dim - 2, true));
  slab_backward_ = batch(slab_.get(), slab_shape, slabs, layer, kinds(0, Dim - 2, false));
  columns_forward_ = batch(columns_.get(), {length}, columns, length, kinds(Dim - 1, Dim - 1, true));
  columns_backward_ = batch(columns_.get(), {length}, columns, length, kinds(Dim - 1, Dim - 1, false));
}

template <int Dim>
void TransformSolver<Dim>::build_inverse_eigenvalues() {
  double scale = grid_.cell_volume();  // FFTW's transforms there and back multiply by 2 n (cosine) or n (Fourier)
  for (int d = 0; d < Dim; ++d) scale *= static_cast<double>(grid_.cells()[d]) * (grid_.periodic(d) ? 1 : 2);
  inverse_eigenvalues_.resize(column_size_);
  for (std::size_t entry = 0; entry < column_size_; ++entry) {
    const Index<Dim> mode = column_index(entry);
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
  WASH_PETSC(PetscSFBcastBegin(grid_to_slab_, MPI_DOUBLE, input, slab_.get(), MPI_REPLACE));
  WASH_PETSC(PetscSFBcastEnd(grid_to_slab_, MPI_DOUBLE, input, slab_.get(), MPI_REPLACE));
  WASH_PETSC(VecRestoreArrayRead(r, &input));
  if (slab_forward_) fftw_execute(slab_forward_.get());

  WASH_PETSC(PetscSFBcastBegin(slab_to_columns_, MPI_DOUBLE, slab_.get(), columns_.get(), MPI_REPLACE));
  WASH_PETSC(PetscSFBcastEnd(slab_to_columns_, MPI_DOUBLE, slab_.get(), columns_.get(), MPI_REPLACE));
  if (columns_forward_) fftw_execute(columns_forward_.get());
  for (std::size_t entry = 0; entry < column_size_; ++entry) columns_[entry] *= inverse_eigenvalues_[entry];
  if (columns_backward_) fftw_execute(columns_backward_.get());

  WASH_PETSC(PetscSFReduceBegin(slab_to_columns_, MPI_DOUBLE, columns_.get(), slab_.get(), MPI_REPLACE));
  WASH_PETSC(PetscSFReduceEnd(slab_to_columns_, MPI_DOUBLE, columns_.get(), slab_.get(), MPI_REPLACE));
  if (slab_backward_) fftw_execute(slab_backward_.get());
  double* output = nullptr;
  WASH_PETSC(VecGetArray(phi, &output));
  WASH_PETSC(PetscSFReduceBegin(grid_to_slab_, MPI_DOUBLE, slab_.get(), output, MPI_REPLACE));
  WASH_PETSC(PetscSFReduceEnd(grid_to_slab_, MPI_DOUBLE, slab_.get(), output, MPI_REPLACE));
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
