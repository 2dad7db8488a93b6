// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "washfsi/coupling/delta.hpp"
#include "washfsi/forcing/surface_markers.hpp"

namespace washfsi {

/// The overlap of two deltas along an axis as a function of their distance in cells.
class AxisOverlap {
 public:
  explicit AxisOverlap(const DeltaOptions& delta);
  double operator()(double shift) const;

 private:
  std::vector<double> values_;  ///< at equal steps from 0 on
};

/// An approximate inverse of J S over a body's patches: what one unit of force on a patch moves at another without
/// pressure, the mean overlap of their markers' deltas. Deltas hardly feel where they lie on the grid, so that it is
/// taken as a function of the difference of two places and made once for all, in the body's frame. Its smallest
/// eigenvalues, which belong to forces that the water does not feel, are raised.
template <int Dim>
class OverlapInverse {
 public:
  OverlapInverse(const MarkerPatches<Dim>& patches, const Point<Dim>& cell, const DeltaOptions& delta);
  ~OverlapInverse();
  OverlapInverse(OverlapInverse&&) noexcept;

  /// Forces that move the patches by these velocities, both per unit of overlap.
  Points<Dim> operator()(const Points<Dim>& velocities) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

extern template class OverlapInverse<2>;
extern template class OverlapInverse<3>;

}  // namespace washfsi
