// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/grid.hpp"

#include <algorithm>
#include <string>

#include "washfsi/grid/partition.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

// The narrow DM decides the partition; the others follow it.
template <int Dim>
petsc::Dm create_stencil_dm(MPI_Comm comm, const GridShape<Dim>& shape) {
  std::array<DMBoundaryType, 3> ends{DM_BOUNDARY_NONE, DM_BOUNDARY_NONE, DM_BOUNDARY_NONE};
  for (int d = 0; d < Dim; ++d) ends[d] = shape.periodic[d] ? DM_BOUNDARY_PERIODIC : DM_BOUNDARY_GHOSTED;
  petsc::Dm dm;
  const auto& n = shape.cells;
  if constexpr (Dim == 2)
    WASH_PETSC(DMDACreate2d(comm, ends[0], ends[1], DMDA_STENCIL_STAR, n[0], n[1], PETSC_DECIDE, PETSC_DECIDE, 1, 1,
                            nullptr, nullptr, dm.put()));
  else
    WASH_PETSC(DMDACreate3d(comm, ends[0], ends[1], ends[2], DMDA_STENCIL_STAR, n[0], n[1], n[2], PETSC_DECIDE,
                            PETSC_DECIDE, PETSC_DECIDE, 1, 1, nullptr, nullptr, nullptr, dm.put()));
  WASH_PETSC(DMSetUp(dm));
  return dm;
}

// A DM on the same partition with other components or stencil.
template <int Dim>
petsc::Dm create_sibling(DM dm, PetscInt components, PetscInt ghost_width) {
  MPI_Comm comm = PetscObjectComm(reinterpret_cast<PetscObject>(dm));
  PetscInt m = 0, n = 0, p = 0;
  std::array<PetscInt, 3> cells{};
  std::array<DMBoundaryType, 3> ends{};
  WASH_PETSC(DMDAGetInfo(dm, nullptr, &cells[0], &cells[1], &cells[2], &m, &n, &p, nullptr, nullptr, &ends[0], &ends[1],
                         &ends[2], nullptr));
  const PetscInt *lx = nullptr, *ly = nullptr, *lz = nullptr;
  WASH_PETSC(DMDAGetOwnershipRanges(dm, &lx, &ly, &lz));
  petsc::Dm sibling;
  if constexpr (Dim == 2)
    WASH_PETSC(DMDACreate2d(comm, ends[0], ends[1], DMDA_STENCIL_BOX, cells[0], cells[1], m, n, components, ghost_width,
                            lx, ly, sibling.put()));
  else
    WASH_PETSC(DMDACreate3d(comm, ends[0], ends[1], ends[2], DMDA_STENCIL_BOX, cells[0], cells[1], cells[2], m, n, p,
                            components, ghost_width, lx, ly, lz, sibling.put()));
  WASH_PETSC(DMSetUp(sibling));
  return sibling;
}

std::vector<PetscInt> running_sum(const PetscInt* lengths, PetscInt count) {
  std::vector<PetscInt> ends(lengths, lengths + count);
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  return ends;
}

}  // namespace

template <int Dim>
Grid<Dim>::Grid(MPI_Comm comm, const GridShape<Dim>& shape) : GridGeometry<Dim>(shape), comm_(comm) {
  create_partition(shape);
  cell_dm_ = create_sibling<Dim>(stencil_dm_, 1, 1);
  face_dm_ = create_sibling<Dim>(stencil_dm_, Dim, 1);
  wide_face_dm_ = create_sibling<Dim>(stencil_dm_, Dim, shape.ghost_width);

  DMDALocalInfo info;
  WASH_PETSC(DMDAGetLocalInfo(wide_face_dm_, &info));
  const Index<3> start{info.xs, info.ys, info.zs}, count{info.xm, info.ym, info.zm};
  const Index<3> ghost_start{info.gxs, info.gys, info.gzs}, ghost_count{info.gxm, info.gym, info.gzm};
  for (int d = 0; d < Dim; ++d) {
    owned_.lower[d] = start[d];
    owned_.upper[d] = start[d] + count[d];
    local_.lower[d] = ghost_start[d];
    local_.upper[d] = ghost_start[d] + ghost_count[d];
  }
}

template <int Dim>
void Grid<Dim>::create_partition(const GridShape<Dim>& shape) {
  const std::string too_few = "-grid_cells: too few cells for " + std::to_string(ranks_of(comm_)) + " ranks: ";
  {
    const petsc::MutedErrors muted;
    try {
      stencil_dm_ = create_stencil_dm(comm_, shape);
    } catch (const petsc::Error&) {
      throw InputError(too_few + muted.message());
    }
  }
  WASH_PETSC(DMSetApplicationContext(stencil_dm_, this));  // for preconditioners that need the spacing
  std::array<const PetscInt*, 3> lengths{};
  std::array<PetscInt, 3> parts{};
  WASH_PETSC(DMDAGetOwnershipRanges(stencil_dm_, &lengths[0], &lengths[1], &lengths[2]));
  WASH_PETSC(DMDAGetInfo(stencil_dm_, nullptr, nullptr, nullptr, nullptr, &parts[0], &parts[1], &parts[2], nullptr,
                         nullptr, nullptr, nullptr, nullptr, nullptr));
  for (int d = 0; d < Dim; ++d) {
    if (*std::min_element(lengths[d], lengths[d] + parts[d]) < shape.ghost_width)
      throw InputError(too_few + "each needs at least " + std::to_string(shape.ghost_width) + " in each direction");
    part_ends_[d] = running_sum(lengths[d], parts[d]);
  }
}

template <int Dim>
Box<Dim> Grid<Dim>::cells_beside(int axis, End end) const {
  Box<Dim> cells = owned_;
  if (end == End::lower)
    cells.upper[axis] = std::min<PetscInt>(cells.upper[axis], this->periodic(axis) ? 0 : 1);
  else
    cells.lower[axis] = std::max(cells.lower[axis], this->cells()[axis] - (this->periodic(axis) ? 0 : 1));
  return cells;
}

template <int Dim>
Box<Dim> Grid<Dim>::inner_faces(int axis) const {
  Box<Dim> box = owned_;
  if (!this->periodic(axis) && box.lower[axis] == 0) box.lower[axis] = 1;
  return box;
}

template <int Dim>
int Grid<Dim>::owner(const Index<Dim>& cell) const {
  return rank_of_cell<Dim>(
      cell, [this](int axis) -> const auto& { return part_ends_[axis]; });
}

template <int Dim>
Box<Dim> Grid<Dim>::owned_by(int rank) const {
  return cells_of_rank<Dim>(
      rank, [this](int axis) -> const auto& { return part_ends_[axis]; });
}

template <int Dim>
petsc::Vector Grid<Dim>::cell_vector() const {
  petsc::Vector vector;
  WASH_PETSC(DMCreateGlobalVector(cell_dm_, vector.put()));
  WASH_PETSC(VecZeroEntries(vector));
  return vector;
}

template <int Dim>
petsc::Vector Grid<Dim>::face_vector() const {
  petsc::Vector vector;
  WASH_PETSC(DMCreateGlobalVector(face_dm_, vector.put()));
  WASH_PETSC(VecZeroEntries(vector));
  return vector;
}

template class Grid<2>;
template class Grid<3>;

}  // namespace washfsi
