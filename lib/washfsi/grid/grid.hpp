// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "washfsi/grid/grid_geometry.hpp"
#include "washfsi/grid/side.hpp"
#include "washfsi/grid/view.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// The staggered (MAC) grid: one partition of the box into ranks; a cell owns its lower faces. Cell fields
/// (pressure) have one value per cell, face fields (velocity) Dim values per cell: component d is the value on
/// the cell's lower d-face. The faces at the upper ends lie in the ghost layer and belong to `Boundary`.
template <int Dim>
class Grid : public GridGeometry<Dim> {
 public:
  /// Collective. Errors: InputError as `GridGeometry`, and if a rank's part would be thinner than the ghost layer.
  Grid(MPI_Comm comm, const GridShape<Dim>& shape);
  Grid(const Grid&) = delete;
  Grid& operator=(const Grid&) = delete;

  MPI_Comm comm() const { return comm_; }

  DM cell_dm() const { return cell_dm_; }
  /// Face DM with one ghost layer, as divergence, Laplacian and central advection need.
  DM face_dm() const { return face_dm_; }
  /// Face DM with `ghost_width` layers; its global vectors are those of `face_dm`.
  DM wide_face_dm() const { return wide_face_dm_; }
  /// Cell DM with one ghost layer and a star stencil: for the pressure operator and its preconditioners;
  /// its application context is this grid.
  DM stencil_dm() const { return stencil_dm_; }

  const Box<Dim>& owned() const { return owned_; }
  /// Owned cells and all `ghost_width` layers of ghosts.
  const Box<Dim>& local() const { return local_; }
  /// Owned cells along a side of the box; none along periodic directions.
  Box<Dim> cells_beside(int axis, End end) const;
  /// Owned faces normal to `axis` that are unknowns: all but the face in the lower boundary.
  Box<Dim> inner_faces(int axis) const;
  /// Calls kernel(face, c) for all inner faces, row by row along x, in each row component by component, so that a row
  /// of interleaved fields is read once; c is a compile-time constant.
  template <class Kernel>
  void for_each_inner_face(Kernel&& kernel) const {
    for_each_inner_face(owned_, kernel);
  }
  /// Calls kernel(face, c) likewise for the inner faces with indices in a box.
  template <class Kernel>
  void for_each_inner_face(const Box<Dim>& box, Kernel&& kernel) const {
    std::array<Box<Dim>, Dim> inner;
    for (int axis = 0; axis < Dim; ++axis) inner[axis] = inner_faces(axis);
    for_each_row<Dim>(owned_.common(box), [&](const Box<Dim>& row) {
      for_each_component<Dim>(
          [&](auto c) { for_each<Dim>(inner[c].common(row), [&](const Index<Dim>& face) { kernel(face, c); }); });
    });
  }

  /// Calls kernel(face, c) for the other owned faces: those in the lower boundaries.
  template <class Kernel>
  void for_each_lower_boundary_face(Kernel&& kernel) const {
    for (int axis = 0; axis < Dim; ++axis) {
      Box<Dim> plane = owned_;
      plane.upper[axis] = inner_faces(axis).lower[axis];
      for_each<Dim>(plane, [&](const Index<Dim>& face) { kernel(face, axis); });
    }
  }

  /// The rank that owns a cell of the box.
  int owner(const Index<Dim>& cell) const;
  /// The cells that another rank owns.
  Box<Dim> owned_by(int rank) const;

  petsc::Vector cell_vector() const;  ///< zero, global
  petsc::Vector face_vector() const;  ///< zero, global

 private:
  void create_partition(const GridShape<Dim>& shape);

  MPI_Comm comm_;
  petsc::Dm cell_dm_, face_dm_, wide_face_dm_, stencil_dm_;
  Box<Dim> owned_, local_;
  std::array<std::vector<PetscInt>, Dim> part_ends_;  ///< per direction, end of each rank's range of cells
};

extern template class Grid<2>;
extern template class Grid<3>;

}  // namespace washfsi
