// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cloth_mesh.hpp"

namespace washfsi {

template <int Dim>
ClothMesh<Dim>::ClothMesh(const Cloths<Dim>& cloths) {
  for (const LatticePart& part : cloths.lattices().parts()) add_part(cloths, part);
}

// Row by row of the lattice.
template <int Dim>
void ClothMesh<Dim>::add_part(const Cloths<Dim>& cloths, const LatticePart& part) {
  const std::size_t width = cloths.group_of(part).sheet.width;
  const auto first = static_cast<std::size_t>(cloths.pieces()[part.piece].first);
  const auto marker = [&](std::size_t m) { return part.first_in_halo + m; };
  numbers.insert(numbers.end(), part.markers.begin(), part.markers.end());
  for (std::size_t m = part.own_begin; m < part.own_end; ++m) {
    const bool below = m + width < part.markers.size(),
               beside = (static_cast<std::size_t>(part.markers[m]) - first) % width + 1 < width;
    if (below) edges.push_back({marker(m), marker(m + width)});
    if (beside) edges.push_back({marker(m), marker(m + 1)});
    if (below && beside) edges.push_back({marker(m), marker(m + width + 1)});
    if constexpr (Dim == 3) {
      if (!below || !beside) continue;
      faces.push_back({marker(m), marker(m + width), marker(m + width + 1)});
      faces.push_back({marker(m), marker(m + width + 1), marker(m + 1)});
    } else if (below) {
      faces.push_back(edges.back());
    }
  }
  piece_of_edge.resize(edges.size(), part.piece);
  piece_of_face.resize(faces.size(), part.piece);
}

template struct ClothMesh<2>;
template struct ClothMesh<3>;

}  // namespace washfsi
