// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/marker_layout/surface_markers.hpp"
#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// An approximate inverse of J S over the patches of each body by itself. O is the velocity at one patch under unit
/// force on another without pressure: the mean overlap of the kernels of their markers. It hardly depends on where
/// markers lie on the grid, so it is taken as a function of the distance vector of two markers and computed once, in
/// the frame of the body. Its smallest eigenvalues belong to forces to which the water does not respond and are raised.
/// With D_O the row sums of O, O + 0.3 D_O is inverted by a fixed number of steps of Chebyshev's method, whose bounds
/// are known; PETSc prefix walls_overlap_. Each rank has the rows of its own patches.
template <int Dim>
class OverlapInverse {
 public:
  /// `own` are this rank's patches, counted over all bodies; ranks have them in rank order. Collective.
  OverlapInverse(const std::vector<MarkerPatches<Dim>>& bodies, const MarkerLayout<Dim>& layout, PatchRange own);

  /// Forces on this rank's patches that, with those on all others, give these velocities; both per unit of overlap.
  /// Collective.
  Points<Dim> operator()(const Points<Dim>& velocities) const;
  /// Filters values: the mean over all patches, weighted by their overlap with each patch. Collective.
  Points<Dim> means_about(const Points<Dim>& values) const;

 private:
  void create_solver(MPI_Comm comm);

  std::vector<double> roots_;  ///< square roots of D_O for this rank's patches
  petsc::Matrix raised_;       ///< D_O^-1/2 O D_O^-1/2 + 0.3 I, the same for all coordinates
  petsc::Solver solver_;
  mutable petsc::Vector right_, solution_;
};

extern template class OverlapInverse<2>;
extern template class OverlapInverse<3>;

}  // namespace washfsi
