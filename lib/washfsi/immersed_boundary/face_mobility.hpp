// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/immersed_boundary/transfer.hpp"

namespace washfsi {

/// The mobility of `MobilityMatrix` without a matrix: forces are spread to faces, and velocities interpolated from
/// them. Where many markers are within each other's deltas, this costs much less than visiting their pairs. Each rank
/// stores the box of the faces that its own markers reach and receives what markers of other ranks spread into it.
template <int Dim>
class FaceMobility {
 public:
  /// Both deltas must have the same width.
  FaceMobility(const Grid<Dim>& grid, const DeltaOptions& delta)
      : grid_(grid), delta_(delta), stencils_(AxisDelta(delta.kernel, delta.spread_width)) {}

  /// Estimates whether the markers of all ranks have so many pairs within reach that this product is faster than the
  /// matrix. `positions` are of all markers within twice the reach of this rank's, which are `count` from `first` on.
  /// Collective.
  bool is_faster(const Points<Dim>& positions, std::size_t first, std::size_t count) const;

  /// Fixes the mobility. `positions` and `row_sums` are of this rank's markers; the diagonal is raised by `own_share`
  /// of itself. Collective.
  void locate(const Points<Dim>& positions, const std::vector<double>& row_sums, double own_share);
  /// Collective.
  Points<Dim> times(const Points<Dim>& values) const;

 private:
  /// The faces of one component, as `FaceStencil` visits them.
  struct Faces;
  double pairs_within_reach(const Points<Dim>& positions, std::size_t first, std::size_t count) const;
  template <class Stencils>
  void enclose(const Stencils& stencils);
  void find_shared(const std::vector<Box<Dim>>& boxes);
  template <class Stencils>
  void spread(const Stencils& stencils, const Points<Dim>& values) const;
  template <class Visit>
  void visit_images(const Visit& visit) const;
  void add_others() const;
  template <class Stencils>
  Points<Dim> interpolate(const Stencils& stencils) const;
  Points<Dim> overlaps(const Points<Dim>& values) const;

  const Grid<Dim>& grid_;
  DeltaOptions delta_;
  FaceStencils<Dim> stencils_;
  std::vector<double> scales_;  ///< factors of the markers: the overlap of two times the roots of both is an entry
  Points<Dim> own_;             ///< added diagonal entries of each marker
  Box<Dim> box_{};              ///< box of all faces within the deltas of this rank's markers
  mutable std::vector<double> faces_;  ///< values on the box's faces during a product, component by component
  petsc::StarForest others_;           ///< from the faces of other ranks to those that are this rank's too
  std::vector<std::size_t> shared_;    ///< numbers of the faces that other ranks have too
  mutable std::vector<double> values_of_others_;
};

extern template class FaceMobility<2>;
extern template class FaceMobility<3>;

}  // namespace washfsi
