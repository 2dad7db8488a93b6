// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/shape.hpp"
#include "washfsi/forcing/even_spread.hpp"
#include "washfsi/forcing/marker_layout.hpp"
#include "washfsi/geometry/near_search.hpp"

namespace washfsi {

/// Markers on the surface of a shape, in its frame, within a region: evenly spread, half a patch's spacing apart, and
/// gathered in patches about evenly spread middles. Fewer forces than markers keep the forces well determined, while
/// their markers leave no gaps. They lie behind the surface by as much as their delta acts before them: by
/// `KernelMoments::retraction`, and by 1/2 sum_d sigma^2 h_d^2 d2Phi/dx_d2 more, since the delta of a marker on a
/// convex surface lies outside for the most part. A part that is thinner than its markers act gets one sheet of them.
/// The same on any number of ranks. Collective.
template <int Dim>
MarkerPatches<Dim> surface_markers(const Shape<Dim>& shape, const Bounds<Dim>& region, const MarkerLayout<Dim>& layout);

}  // namespace washfsi
