// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// The facets of all cloths of all ranks, by the numbers of their markers. A cell of a lattice is split into two
/// triangles; a fibre has segments alone.
template <int Dim>
struct Facets {
  using Edge = std::array<std::size_t, 2>;
  using Face = std::array<std::size_t, Dim>;  ///< a segment in the plane, a triangle in space

  explicit Facets(const Cloths<Dim>& cloths);

  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<double> marker_areas;  ///< undeformed, of all markers [m2; m in the plane]
  std::vector<double> edge_lengths;  ///< undeformed [m]

 private:
  void add_edge(std::size_t from, std::size_t to, double length);
  void add_fibre(const Piece& piece, const Sheet& sheet);
  void add_sheet(const Piece& piece, const Sheet& sheet);
};

/// The least spacing of markers along the lattices [m]; infinite without cloth.
template <int Dim>
double least_spacing(const Cloths<Dim>& cloths);

extern template struct Facets<2>;
extern template struct Facets<3>;

}  // namespace washfsi
