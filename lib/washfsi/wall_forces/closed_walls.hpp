// SPDX-License-Identifier: BSD-3-Clause
//
// Where a body's walls part the water, as those of a ball or a drum do, the same force per area along all of their
// normals is a jump of the pressure, which an incompressible water does not feel: div u = 0 on either side leaves no
// flow through the walls as a whole. Such forces are no unknowns, and the mean velocity through the walls, which is
// that of the deltas alone, no condition. Left in, markers would fight it with forces without bound.
#pragma once

#include "washfsi/marker_layout/body_markers.hpp"

namespace washfsi {

template <int Dim>
class ClosedWalls {
 public:
  /// Bodies that are thinner than a cell somewhere are not closed. Collective.
  ClosedWalls(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const BodyMarkers<Dim>& markers);

  /// Places them as the bodies are at `time`. A body is open while another covers a marker of it. The
  /// states are those of this rank's markers, patch by patch. Collective.
  void update(const std::vector<typename BodyMarkers<Dim>::State>& states, double time);

  /// Takes such forces, or the velocity through the walls as a whole, from values of this rank's patches. Collective.
  void remove_from(Points<Dim>& values) const;

 private:
  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  std::vector<std::size_t> body_of_, sizes_;  ///< of this rank's patches; of these, in markers
  Points<Dim> normals_;                       ///< of these, out of the bodies, in their frames
  std::vector<double> thin_patches_;          ///< of the bodies, how many are thinner
  Points<Dim> areas_;                         ///< of the patches now, along the normal, in markers; 0 of open walls
  std::vector<double> squares_;               ///< of the bodies, the sum of these squared
};

extern template class ClosedWalls<2>;
extern template class ClosedWalls<3>;

}  // namespace washfsi
