// SPDX-License-Identifier: BSD-3-Clause
//
// Where a body's walls separate the water inside from that outside, as those of a ball or a drum do, a uniform force
// per area along all of their normals is a jump of the pressure, to which incompressible water does not respond: with
// div u = 0 on either side there is no net flow through the walls. This uniform force is removed from the unknowns, and
// the mean velocity through the walls, an artefact of the deltas, from the conditions; else forces would grow without
// bound.
#pragma once

#include "washfsi/marker_layout/body_markers.hpp"

namespace washfsi {

template <int Dim>
class ClosedWalls {
 public:
  /// Bodies thinner than a cell somewhere do not count as closed. Collective.
  ClosedWalls(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const BodyMarkers<Dim>& markers);

  /// Places the walls as the bodies are at `time`. A body is open while another covers a marker of it. `states` are
  /// those of this rank's markers, patch by patch. Collective.
  void update(const std::vector<typename BodyMarkers<Dim>::State>& states, double time);

  /// Subtracts the uniform normal force, or the mean normal velocity, of closed walls from values of this rank's
  /// patches. Collective.
  void remove_from(Points<Dim>& values) const;

 private:
  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  std::vector<std::size_t> body_of_, sizes_;  ///< body and number of markers of each of this rank's patches
  Points<Dim> normals_;                       ///< their outward normals in their bodies' frames; 0 where thin
  std::vector<double> thin_patches_;          ///< number of patches of each body where it is thinner than a cell
  Points<Dim> weighted_normals_;              ///< acting markers of each patch times its normal in space
  /// For each body: the sum over its patches of the squared counts of acting markers; 0 for open walls.
  std::vector<double> squares_;
};

extern template class ClosedWalls<2>;
extern template class ClosedWalls<3>;

}  // namespace washfsi
