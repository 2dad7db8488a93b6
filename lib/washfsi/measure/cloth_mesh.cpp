// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/cloth_mesh.hpp"

namespace washfsi {

template <int Dim>
ClothMesh<Dim>::ClothMesh(const Cloths<Dim>& cloths) {
  for (const Patch& patch : cloths.patches()) add_patch(cloths, patch);
}

// Row by row of the lattice.
template <int Dim>
void ClothMesh<Dim>::add_patch(const Cloths<Dim>& cloths, const Patch& patch) {
  const std::size_t width = cloths.group_of(patch).sheet.width;
  const auto first = static_cast<std::size_t>(cloths.pieces()[patch.piece].first);
  const auto marker = [&](std::size_t m) { return patch.first_in_halo + m; };
  numbers.insert(numbers.end(), patch.markers.begin(), patch.markers.end());
  for (std::size_t m = patch.own_begin; m < patch.own_end; ++m) {
    const bool below = m + width < patch.markers.size(),
               beside = (static_cast<std::size_t>(patch.markers[m]) - first) % width + 1 < width;
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
  piece_of_edge.resize(edges.size(), patch.piece);
  piece_of_face.resize(faces.size(), patch.piece);
}

template struct ClothMesh<2>;
template struct ClothMesh<3>;

}  // namespace washfsi
