// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/geometry/near_search.hpp"
#include "washfsi/marker_layout/even_spread.hpp"
#include "washfsi/marker_layout/marker_layout.hpp"
#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// A region of a shape's surface, in the shape's frame.
template <int Dim>
struct Surface {
  const Shape<Dim>* shape;
  Bounds<Dim> region;
  MarkerLayout<Dim> layout;
};

/// Markers on surfaces, each in its shape's frame and within its region: evenly spread, about half a cell apart,
/// and gathered in patches about evenly spread middles. Fewer forces than markers keep the forces well determined,
/// while their markers leave no gaps. They are retracted behind the surface by the reach of their kernel: by
/// `KernelMoments::retraction`, and by 1/2 sum_d var phi h_d^2 d2Phi/dx_d2 more, since the kernel of a marker on a
/// convex surface lies mostly outside; var phi is its variance in cells^2. A part thinner than the reach of its markers
/// gets one sheet of them. The result is the same on any number of ranks, which all layouts must share. Collective.
template <int Dim>
std::vector<MarkerPatches<Dim>> surface_markers(const std::vector<Surface<Dim>>& surfaces);

/// Lays the markers of one shape.
template <int Dim>
MarkerPatches<Dim> surface_markers(const Shape<Dim>& shape, const Bounds<Dim>& region,
                                   const MarkerLayout<Dim>& layout) {
  return surface_markers<Dim>({Surface<Dim>{&shape, region, layout}}).front();
}

}  // namespace washfsi
