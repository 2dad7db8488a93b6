// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "washfsi/grid/grid.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// A surface of simplices: lines in the plane, triangles in space.
template <int Dim>
struct SimplexMesh {
  Points<Dim> vertices;  ///< [m]
  std::vector<std::array<std::size_t, Dim>>
      facets;  ///< their vertices; normals point to where the distance is positive
};

/// The surface on which a signed distance [m] is zero, in the cells of the box: by marching simplices (Kuhn's, of a
/// lattice of half the grid's spacing, finer in cells where the body is thinner than that), linear between the
/// lattice's nodes. The distance must never be beyond the true
/// one. All of it is on rank 0, so that it is the same on any number of ranks; others have none. Collective.
template <int Dim>
SimplexMesh<Dim> zero_surface(const Grid<Dim>& grid, const std::function<double(const Point<Dim>&)>& distance);

}  // namespace washfsi
