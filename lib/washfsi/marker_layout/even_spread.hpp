// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// A place where a marker could be.
template <int Dim>
struct Candidate {
  Point<Dim> place;  ///< [m]
  Point<Dim> foot;   ///< place on the surface that it stands for [m]
  int sharpness;     ///< 0 on a face, 1 on an edge, 2 in a corner
};

/// Markers in patches, within which they share one force.
template <int Dim>
struct MarkerPatches {
  Points<Dim> markers, feet;           ///< markers patch by patch, and their feet on the surface [m]
  std::vector<std::size_t> starts{0};  ///< first marker of each patch, and the end

  std::size_t size() const { return starts.size() - 1; }
  void append(const MarkerPatches& more) {
    for (std::size_t p = 1; p < more.starts.size(); ++p) starts.push_back(markers.size() + more.starts[p]);
    markers.insert(markers.end(), more.markers.begin(), more.markers.end());
    feet.insert(feet.end(), more.feet.begin(), more.feet.end());
  }
  /// Whether the markers of a patch lie in the middle of a thin part, on no face of it.
  bool is_in_sheet(std::size_t patch) const {
    return std::equal(markers.begin() + static_cast<std::ptrdiff_t>(starts[patch]),
                      markers.begin() + static_cast<std::ptrdiff_t>(starts[patch + 1]),
                      feet.begin() + static_cast<std::ptrdiff_t>(starts[patch]));
  }
  /// The middle of a patch's part of the surface.
  Point<Dim> middle(std::size_t patch) const {
    Point<Dim> sum = Point<Dim>::Zero();
    for (std::size_t m = starts[patch]; m < starts[patch + 1]; ++m) sum += feet[m];
    return sum / static_cast<double>(starts[patch + 1] - starts[patch]);
  }
};

/// Some patches, up to one before the end.
struct PatchRange {
  std::size_t begin, end;

  std::size_t size() const { return end - begin; }
};

/// Removes the most crowded of some places, one after the other, until all are a spacing from each other: the rest lie
/// more evenly than places chosen in any fixed order (Yuksel, Comput. Graph. Forum 34 (2015) 25). Then restores places
/// that have room again, so that no gap is wider than two spacings. Prefers corners, then edges.
template <int Dim>
std::vector<Candidate<Dim>> thinned(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing);

/// Spreads places evenly as above, then moves each a few times to the middle of the candidates of its sharpness that
/// are nearest to it (Lloyd's method).
template <int Dim>
std::vector<Candidate<Dim>> spread_evenly(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing);

/// Gathers markers in patches of about equal size, about a spacing across (Yuksel's method for their first middles,
/// then Lloyd's): each joins the nearest middle. If a patch has more than the most allowed, those stay that are nearest
/// to the middles of as many equal parts of it.
template <int Dim>
MarkerPatches<Dim> gathered(std::vector<Candidate<Dim>> markers, std::size_t count, const Point<Dim>& spacing,
                            std::size_t most);

}  // namespace washfsi
