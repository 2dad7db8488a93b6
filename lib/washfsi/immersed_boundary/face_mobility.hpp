// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/immersed_boundary/transfer.hpp"

namespace washfsi {

/// The same mobility as that of `MobilityMatrix`, never formed: forces are spread to faces, and velocities interpolated
/// from them. Where many markers are within each other's deltas, that costs much less than their pairs. A rank has the
/// box of the faces that its own markers reach, and gets from others what theirs have in it.
template <int Dim>
class FaceMobility {
 public:
  /// Both deltas must have the same width.
  FaceMobility(const Grid<Dim>& grid, const DeltaOptions& delta)
      : grid_(grid), delta_(delta), stencils_(AxisDelta(delta.kernel, delta.spread_width)) {}

  /// Whether the markers of all ranks have so many pairs within reach that the product is the faster one, by an
  /// estimate. Given are all that are within twice the reach of this rank's, which are so many from `first` on.
  /// Collective.
  bool is_faster(const Points<Dim>& positions, std::size_t first, std::size_t count) const;

  /// Fixes it. `positions` and `row_sums` are those of this rank's markers; `own_share` as of the matrix. Collective.
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
  std::vector<double> scales_;         ///< of each marker: by their roots the overlap of two becomes an entry
  Points<Dim> own_;                    ///< what each marker has beside it
  Box<Dim> box_{};                     ///< of all faces within the deltas of this rank's markers
  mutable std::vector<double> faces_;  ///< their values during a product, component by component
  petsc::StarForest others_;           ///< from the faces of other ranks to those that are this rank's too
  std::vector<std::size_t> shared_;    ///< numbers of the latter
  mutable std::vector<double> values_of_others_;
};

extern template class FaceMobility<2>;
extern template class FaceMobility<3>;

}  // namespace washfsi
