// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "washfsi/cloth/near_markers.hpp"

namespace washfsi {

/// The facets whose markers a rank all knows, by the places of these among what it knows, and in ascending order. A
/// cell of a lattice is split into two triangles; a fibre has segments alone.
template <int Dim>
struct Facets {
  using Edge = std::array<std::size_t, 2>;
  using Face = std::array<std::size_t, Dim>;  ///< a segment in the plane, a triangle in space

  Facets(const Cloths<Dim>& cloths, const NearMarkers<Dim>& known);

  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<double> marker_areas;  ///< undeformed, of all that is known [m2; m in the plane]
  std::vector<double> edge_lengths;  ///< undeformed [m]
  std::vector<double> face_areas;    ///< an equal share of its cloth's area, undeformed [m2; m in the plane]

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
