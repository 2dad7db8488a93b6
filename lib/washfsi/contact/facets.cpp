// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/contact/facets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace washfsi {

template <int Dim>
Facets<Dim>::Facets(const Cloths<Dim>& cloths) {
  for (const Piece& piece : cloths.pieces()) {
    const ClothGroup<Dim>& group = cloths.groups()[piece.group];
    for (PetscInt marker = 0; marker < piece.count; ++marker)
      marker_areas.push_back(group.marker_share(marker) * group.sheet.part_area());
    if (group.sheet.width == 1)
      add_fibre(piece, group.sheet);
    else
      add_sheet(piece, group.sheet);
  }
}

template <int Dim>
void Facets<Dim>::add_edge(std::size_t from, std::size_t to, double length) {
  edges.push_back({from, to});
  edge_lengths.push_back(length);
}

template <int Dim>
void Facets<Dim>::add_fibre(const Piece& piece, const Sheet& sheet) {
  const auto first = static_cast<std::size_t>(piece.first), count = static_cast<std::size_t>(piece.count);
  for (std::size_t k = 0; k + (sheet.closed ? 0 : 1) < count; ++k)
    add_edge(first + k, first + (k + 1) % count, sheet.ds);
  if constexpr (Dim == 2) faces = edges;
}

template <int Dim>
void Facets<Dim>::add_sheet(const Piece& piece, const Sheet& sheet) {
  if constexpr (Dim == 3) {
    const auto first = static_cast<std::size_t>(piece.first), end = first + static_cast<std::size_t>(piece.count);
    for (std::size_t k = first; k < end; ++k) {
      const std::size_t along = k + sheet.width;
      const bool is_last = (k - first) % sheet.width + 1 == sheet.width;
      if (along < end) add_edge(k, along, sheet.ds);
      if (!is_last) add_edge(k, k + 1, sheet.dr);
      if (along >= end || is_last) continue;
      add_edge(k, along + 1, std::hypot(sheet.ds, sheet.dr));
      faces.push_back({k, along, along + 1});
      faces.push_back({k, along + 1, k + 1});
    }
  }
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
