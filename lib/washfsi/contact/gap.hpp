// SPDX-License-Identifier: BSD-3-Clause
//
// How far two facets of cloths are from each other, and how that changes as their markers move. In the plane a facet is
// a point or a segment, in space a point, a segment or a triangle; a pair of them has Dim + 1 markers.
#pragma once

#include <array>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// The number of markers of a pair of facets.
template <int Dim>
inline constexpr std::size_t pair_markers = Dim + 1;

/// One value per marker of a pair.
template <int Dim>
using PairPoints = std::array<Point<Dim>, pair_markers<Dim>>;

/// The kinds of facets in a pair; the markers of the first come first.
enum class PairKind {
  point_facet,  ///< a point with a segment in the plane, with a triangle in space
  edge_edge,    ///< in space only
};

/// The number of markers of a pair's first facet.
constexpr std::size_t markers_of_first(PairKind kind) {
  return kind == PairKind::edge_edge ? 2 : 1;
}

/// The shortest way between two facets: sum of shares X = distance times normal. The shares of the first facet sum up
/// to 1, those of the second to -1; the gradient of the distance in marker i is shares[i] normal.
template <int Dim>
struct Gap {
  double distance;                               ///< [m]
  Point<Dim> normal;                             ///< from the second to the first; any unit vector where they touch
  std::array<double, pair_markers<Dim>> shares;  ///< shares of the markers
};

/// The gap of a pair whose markers are at these places. Facets may be degenerate.
template <int Dim>
Gap<Dim> gap_of(PairKind kind, const PairPoints<Dim>& places);

/// Where along a segment the point nearest to a place lies, from 0 to 1.
template <int Dim>
double part_along(const Point<Dim>& from, const Point<Dim>& to, const Point<Dim>& place);

}  // namespace washfsi
