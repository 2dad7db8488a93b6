// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// A place where a marker could be.
template <int Dim>
struct Candidate {
  Point<Dim> place;  ///< [m]
  double sharpness;  ///< how much it belongs to an edge
};

/// Markers in patches, within which they share one force.
template <int Dim>
struct MarkerPatches {
  Points<Dim> markers;              ///< patch by patch [m]
  std::vector<std::size_t> starts;  ///< first marker of each patch, and the end

  std::size_t size() const { return starts.size() - 1; }
};

/// Takes away the most crowded of some places, one after the other, until all are a spacing from each other: what is
/// left lies more evenly than places taken in any order (Yuksel, Comput. Graph. Forum 34 (2015) 25). Then takes back
/// what has room again, so that no gap is wider than two spacings. Edges are kept first.
template <int Dim>
std::vector<Candidate<Dim>> spread_evenly(const std::vector<Candidate<Dim>>& candidates, const Point<Dim>& spacing);

/// Moves the chosen, but for those on edges, to the middle of the candidates nearest to each, some times over (Lloyd's
/// method), which evens their distances.
template <int Dim>
std::vector<Candidate<Dim>> relaxed(std::vector<Candidate<Dim>> chosen, const std::vector<Candidate<Dim>>& candidates,
                                    const Point<Dim>& spacing);

/// Patches about the middles: each marker joins the nearest.
template <int Dim>
MarkerPatches<Dim> gathered(const std::vector<Candidate<Dim>>& markers, const std::vector<Candidate<Dim>>& middles,
                            const Point<Dim>& spacing);

}  // namespace washfsi
