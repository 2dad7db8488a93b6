// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/immersed_boundary/face_stencil.hpp"

namespace washfsi {

/// Stencils of many markers, in half the room where their delta is narrow: to fetch them from memory takes as long as
/// to sum over their faces.
template <int Dim>
class FaceStencils {
 public:
  explicit FaceStencils(const AxisDelta& delta) : delta_(delta), are_narrow_(delta.width() <= 2) {}
  /// Stencils of markers at these positions, folded into the box.
  FaceStencils(const AxisDelta& delta, const Grid<Dim>& grid, const Points<Dim>& positions) : FaceStencils(delta) {
    resize(positions.size());
    for (std::size_t m = 0; m < positions.size(); ++m) set(m, grid, grid.folded(positions[m]));
  }

  void resize(std::size_t markers) {
    if (are_narrow_)
      narrow_.resize(markers);
    else
      wide_.resize(markers);
  }
  void set(std::size_t marker, const Grid<Dim>& grid, const Point<Dim>& position) {
    if (are_narrow_)
      narrow_[marker] = {grid, delta_, position};
    else
      wide_[marker] = {grid, delta_, position};
  }
  /// Calls use(stencils), a vector of one kind of `FaceStencil` or the other.
  template <class Use>
  void visit(const Use& use) const {
    if (are_narrow_)
      use(narrow_);
    else
      use(wide_);
  }

 private:
  AxisDelta delta_;
  bool are_narrow_;
  std::vector<FaceStencil<Dim, NarrowAxisStencil>> narrow_;
  std::vector<FaceStencil<Dim>> wide_;
};

}  // namespace washfsi
