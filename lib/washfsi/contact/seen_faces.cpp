// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/seen_faces.hpp"

namespace washfsi {

template <int Dim>
SeenFaces<Dim>::SeenFaces(const Cloths<Dim>& cloths) {
  for (const LatticePart& part : cloths.lattices().parts()) add_part(cloths, part);
}

template <int Dim>
void SeenFaces<Dim>::add_part(const Cloths<Dim>& cloths, const LatticePart& part) {
  const std::size_t width = cloths.group_of(part).sheet.width, count = part.markers.size();
  const double area = cloths.group_of(part).face_area();
  const auto first = static_cast<std::size_t>(cloths.pieces()[part.piece].first);
  for (std::size_t m = 0; m + width < count; ++m) {
    if constexpr (Dim == 2) {
      add(part, {m, m + 1}, area);
    } else {
      if ((static_cast<std::size_t>(part.markers[m]) - first) % width + 1 == width) continue;
      add(part, {m, m + width, m + width + 1}, area);
      add(part, {m, m + width + 1, m + 1}, area);
    }
  }
}

template <int Dim>
void SeenFaces<Dim>::add(const LatticePart& part, const std::array<std::size_t, Dim>& places, double area) {
  Face face{{}, {}, {}, part.piece, area};
  bool any = false;
  for (std::size_t i = 0; i < Dim; ++i) {
    const bool is_own = places[i] >= part.own_begin && places[i] < part.own_end;
    any = any || is_own;
    face.seen[i] = part.first_in_halo + places[i];
    face.own[i] = is_own ? static_cast<std::ptrdiff_t>(part.own_first + places[i] - part.own_begin) : none;
    face.numbers[i] = part.markers[places[i]];
  }
  if (any) faces_.push_back(face);
}

template class SeenFaces<2>;
template class SeenFaces<3>;

}  // namespace washfsi
