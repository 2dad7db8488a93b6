// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/seen_faces.hpp"

namespace washfsi {

template <int Dim>
SeenFaces<Dim>::SeenFaces(const Cloths<Dim>& cloths) {
  for (const Patch& patch : cloths.patches()) add_patch(cloths, patch);
}

template <int Dim>
void SeenFaces<Dim>::add_patch(const Cloths<Dim>& cloths, const Patch& patch) {
  const std::size_t width = cloths.group_of(patch).sheet.width, count = patch.markers.size();
  const double area = cloths.group_of(patch).face_area();
  const auto first = static_cast<std::size_t>(cloths.pieces()[patch.piece].first);
  for (std::size_t m = 0; m + width < count; ++m) {
    if constexpr (Dim == 2) {
      add(patch, {m, m + 1}, area);
    } else {
      if ((static_cast<std::size_t>(patch.markers[m]) - first) % width + 1 == width) continue;
      add(patch, {m, m + width, m + width + 1}, area);
      add(patch, {m, m + width + 1, m + 1}, area);
    }
  }
}

template <int Dim>
void SeenFaces<Dim>::add(const Patch& patch, const std::array<std::size_t, Dim>& places, double area) {
  Face face{{}, {}, {}, patch.piece, area};
  bool any = false;
  for (std::size_t i = 0; i < Dim; ++i) {
    const bool is_own = places[i] >= patch.own_begin && places[i] < patch.own_end;
    any = any || is_own;
    face.seen[i] = patch.first_in_halo + places[i];
    face.own[i] = is_own ? static_cast<std::ptrdiff_t>(patch.own_first + places[i] - patch.own_begin) : none;
    face.numbers[i] = patch.markers[places[i]];
  }
  if (any) faces_.push_back(face);
}

template class SeenFaces<2>;
template class SeenFaces<3>;

}  // namespace washfsi
