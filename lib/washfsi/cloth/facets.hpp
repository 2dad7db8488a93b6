// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/cloth/near_markers.hpp"

namespace washfsi {

/// The facets all of whose markers a rank knows, in ascending order; markers are given by their index among the known
/// ones. A cell of a lattice is split into two triangles; a fibre has segments alone.
template <int Dim>
struct Facets {
  using Edge = std::array<std::size_t, 2>;
  using Face = std::array<std::size_t, Dim>;  ///< a segment in the plane, a triangle in space

  Facets(const Cloths<Dim>& cloths, const NearMarkers<Dim>& known);

  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<double> marker_areas;  ///< undeformed areas of all known markers [m2; m in the plane]
  std::vector<double> edge_lengths;  ///< undeformed lengths of the edges [m]
  std::vector<double> face_areas;    ///< undeformed areas: equal shares of the cloth's area [m2; m in the plane]

 private:
  using Others = std::array<std::optional<std::size_t>, 3>;
  void add_edge(std::size_t from, std::optional<std::size_t> to, double length);
  void add_faces(std::size_t from, const Others& others, double area);
};

/// The least spacing of markers along the lattices [m]; infinite without cloth.
template <int Dim>
double least_spacing(const Cloths<Dim>& cloths);

extern template struct Facets<2>;
extern template struct Facets<3>;

}  // namespace washfsi
