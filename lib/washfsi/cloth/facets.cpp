// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/facets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace washfsi {

namespace {

// The known markers after one: in the next row, in that beside it, and beside it. None beyond a cloth's sides, but
// round a closed one.
template <int Dim>
class Neighbours {
 public:
  Neighbours(const Cloths<Dim>& cloths, const NearMarkers<Dim>& known) : cloths_(cloths), known_(known) {}

  std::array<std::optional<std::size_t>, 3> of(std::size_t marker) const {
    const Piece& piece = cloths_.pieces()[known_.piece_of(marker)];
    const Sheet& sheet = cloths_.groups()[piece.group].sheet;
    const auto count = static_cast<std::size_t>(piece.count);
    const std::size_t first = static_cast<std::size_t>(piece.first), in_cloth = known_.numbers()[marker] - first;
    const bool has_row = sheet.closed || in_cloth + sheet.width < count, has_next = (in_cloth + 1) % sheet.width != 0;
    const auto at = [&](bool exists, std::size_t step) {
      return exists ? place(first + (in_cloth + step) % count, marker + step) : std::nullopt;
    };
    return {at(has_row, sheet.width), at(has_row && has_next, sheet.width + 1), at(has_next, 1)};
  }

 private:
  // If the whole cloth is known, the guess is right.
  std::optional<std::size_t> place(std::size_t number, std::size_t guess) const {
    const auto is_at = [&](std::size_t place) { return place < known_.size() && known_.numbers()[place] == number; };
    if (is_at(guess)) return guess;
    const std::size_t place = known_.place_of(number);
    return is_at(place) ? std::optional(place) : std::nullopt;
  }

  const Cloths<Dim>& cloths_;
  const NearMarkers<Dim>& known_;
};

}  // namespace

template <int Dim>
Facets<Dim>::Facets(const Cloths<Dim>& cloths, const NearMarkers<Dim>& known) {
  std::vector<double> areas;
  for (const ClothGroup<Dim>& group : cloths.groups()) areas.push_back(group.face_area());
  const Neighbours<Dim> neighbours(cloths, known);
  for (std::size_t marker = 0; marker < known.size(); ++marker) {
    const Piece& piece = cloths.pieces()[known.piece_of(marker)];
    const ClothGroup<Dim>& group = cloths.groups()[piece.group];
    const auto in_cloth = static_cast<PetscInt>(known.numbers()[marker]) - piece.first;
    marker_areas.push_back(group.marker_share(in_cloth) * group.sheet.part_area());
    const Others others = neighbours.of(marker);
    const auto& [along, aslant, beside] = others;
    add_edge(marker, along, group.sheet.ds);
    add_edge(marker, beside, group.sheet.dr);
    add_edge(marker, aslant, std::hypot(group.sheet.ds, group.sheet.dr));
    add_faces(marker, others, areas[piece.group]);
  }
}

template <int Dim>
void Facets<Dim>::add_edge(std::size_t from, std::optional<std::size_t> to, double length) {
  if (!to) return;
  edges.push_back({from, *to});
  edge_lengths.push_back(length);
}

template <int Dim>
void Facets<Dim>::add_faces(std::size_t from, const Others& others, double area) {
  const auto& [along, aslant, beside] = others;
  if constexpr (Dim == 2) {
    if (along) faces.push_back({from, *along});
  } else if (aslant) {
    if (along) faces.push_back({from, *along, *aslant});
    if (beside) faces.push_back({from, *aslant, *beside});
  }
  face_areas.resize(faces.size(), area);
}

template <int Dim>
double least_spacing(const Cloths<Dim>& cloths) {
  double spacing = std::numeric_limits<double>::infinity();
  for (const ClothGroup<Dim>& group : cloths.groups()) {
    spacing = std::min(spacing, group.sheet.ds);
    if (group.sheet.width > 1) spacing = std::min(spacing, group.sheet.dr);
  }
  return spacing;
}

template double least_spacing<2>(const Cloths<2>&);
template double least_spacing<3>(const Cloths<3>&);
template struct Facets<2>;
template struct Facets<3>;

}  // namespace washfsi
