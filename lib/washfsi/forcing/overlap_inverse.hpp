// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "washfsi/forcing/surface_markers.hpp"

namespace washfsi {

/// Some patches of a body, up to one before the end.
struct PatchRange {
  std::size_t begin, end;
};

/// An approximate inverse of J S over a body's patches: what one unit of force on a patch moves at another without
/// pressure, the mean overlap of their markers' deltas. Deltas hardly feel where they lie on the grid, so that it is
/// taken as a function of the difference of two places and made once for all, in the body's frame. Its smallest
/// eigenvalues, which belong to forces that the water does not feel, are raised.
template <int Dim>
class OverlapInverse {
 public:
  OverlapInverse(const MarkerPatches<Dim>& patches, const MarkerLayout<Dim>& layout);
  ~OverlapInverse();
  OverlapInverse(OverlapInverse&&) noexcept;

  /// Forces on some of the patches, where those on all move them by these velocities, both per unit of overlap.
  Points<Dim> operator()(const Points<Dim>& velocities, PatchRange wanted) const;
  /// The mean about some of the patches of values of all, weighed by their overlap with it.
  Points<Dim> means_about(const Points<Dim>& values, PatchRange wanted) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

extern template class OverlapInverse<2>;
extern template class OverlapInverse<3>;

}  // namespace washfsi
