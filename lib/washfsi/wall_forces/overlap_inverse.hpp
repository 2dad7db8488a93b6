// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/marker_layout/surface_markers.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// An approximate inverse of J S over the patches of all bodies, each alone: what one unit of force on a patch moves at
/// another without pressure, O, the mean overlap of their markers' deltas. Deltas hardly feel where they lie on the
/// grid, so that it is taken as a function of the difference of two places and made once for all, in the body's frame.
/// Its smallest eigenvalues, which belong to forces that the water does not feel, are raised: with D the sums of its
/// rows, O + 0.3 D is inverted by so many steps of Chebyshev's method, whose bounds are known; PETSc prefix
/// walls_overlap_. Each rank has the rows of its own patches.
template <int Dim>
class OverlapInverse {
 public:
  /// Of the patches of all bodies in a row these are this rank's; ranks have them in rank order. Collective.
  OverlapInverse(const std::vector<MarkerPatches<Dim>>& bodies, const MarkerLayout<Dim>& layout, PatchRange own);

  /// Forces on this rank's patches, where those on all move them by these velocities, both per unit of overlap.
  /// Collective.
  Points<Dim> operator()(const Points<Dim>& velocities) const;
  /// The mean about each patch of all values, weighed by their overlap with it. Collective.
  Points<Dim> means_about(const Points<Dim>& values) const;

 private:
  void create_solver(MPI_Comm comm);

  std::vector<double> roots_;  ///< of D of this rank's patches
  petsc::Matrix raised_;       ///< D^-1/2 O D^-1/2 + 0.3, alike for all coordinates
  petsc::Solver solver_;
  mutable petsc::Vector right_, solution_;
};

extern template class OverlapInverse<2>;
extern template class OverlapInverse<3>;

}  // namespace washfsi
