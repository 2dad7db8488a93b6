// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "washfsi/grid/grid.hpp"
#include "washfsi/grid/side.hpp"

namespace washfsi {

inline constexpr std::array<End, 2> both_ends{End::lower, End::upper};

/// Whether this rank has cells beside a side of the box; false on periodic axes, which have none.
template <int Dim>
bool touches(const Grid<Dim>& grid, int axis, End end) {
  if (grid.periodic(axis)) return false;
  return end == End::lower ? grid.owned().lower[axis] == 0 : grid.owned().upper[axis] == grid.cells()[axis];
}

/// Calls visit(face) for the faces that lie in a side, over the extent of `part` along the other axes.
template <int Dim, class Visit>
void for_each_side_face(const Grid<Dim>& grid, int axis, End end, const Box<Dim>& part, Visit&& visit) {
  Box<Dim> plane = part;
  plane.lower[axis] = end == End::lower ? 0 : grid.cells()[axis];
  plane.upper[axis] = plane.lower[axis] + 1;
  for_each<Dim>(plane, visit);
}

/// Calls visit(ghost, mirror) for the ghosts of `part` beyond one side and the face of this component that each
/// mirrors. The axis is known when this is compiled, so that indices stay in registers.
template <int Axis, int Dim, class Visit>
void for_each_ghost(const Grid<Dim>& grid, End end, int component, const Box<Dim>& part, Visit&& visit) {
  const bool normal = component == Axis;  // faces lie in the boundary, not half a cell from it
  const PetscInt n = grid.cells()[Axis];
  Box<Dim> beyond = part;
  if (end == End::lower)
    beyond.upper[Axis] = 0;
  else
    beyond.lower[Axis] = normal ? n + 1 : n;
  const PetscInt pivot = (end == End::lower ? 0 : 2 * n) - (normal ? 0 : 1);
  for_each<Dim>(beyond, [&](const Index<Dim>& ghost) {
    Index<Dim> mirror = ghost;
    mirror[Axis] = pivot - ghost[Axis];
    visit(ghost, mirror);
  });
}

/// The place of a side opposite to a face.
template <int Dim>
Point<Dim> foot_on_side(const Grid<Dim>& grid, const Index<Dim>& face, int component, int axis, End end) {
  Point<Dim> place = grid.face_center(face, component);
  place[axis] = end == End::lower ? grid.lower()[axis] : grid.upper()[axis];
  return place;
}

}  // namespace washfsi
