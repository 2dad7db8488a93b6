// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/delta.hpp"
#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// The faces within the delta of one marker, of all velocity components: weights along each axis, whose products are
/// those of the faces.
template <int Dim>
class FaceStencil {
 public:
  FaceStencil(const Grid<Dim>& grid, DeltaKernel kernel, double width, const Point<Dim>& position) {
    for (int d = 0; d < Dim; ++d) {
      const double place = (position[d] - grid.lower()[d]) / grid.spacing()[d];
      axes_[static_cast<std::size_t>(d)] = {axis_stencil(kernel, place, width),
                                            axis_stencil(kernel, place - 0.5, width)};
    }
  }

  /// Weights along an axis of the faces of a component: those normal to the axis or those between.
  const AxisStencil& along(int axis, int component) const {
    return axes_[static_cast<std::size_t>(axis)][axis == component ? 0 : 1];
  }

  /// Calls visit(face, weight) for the first face of each row along x of a component's faces; the weight of the row
  /// times that along x is a face's.
  template <class Visit>
  void visit_rows(int component, Visit&& visit) const {
    Box<Dim> rows;
    for (int d = 0; d < Dim; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      rows.lower[axis] = along(d, component).first;
      rows.upper[axis] = rows.lower[axis] + (d == 0 ? 1 : along(d, component).count);
    }
    for_each<Dim>(rows, [&](const Index<Dim>& face) {
      double weight = 1;
      for (int d = 1; d < Dim; ++d) {
        const AxisStencil& stencil = along(d, component);
        weight *= stencil.weight[static_cast<std::size_t>(face[static_cast<std::size_t>(d)] - stencil.first)];
      }
      visit(face, weight);
    });
  }

 private:
  std::array<std::array<AxisStencil, 2>, Dim> axes_;
};

}  // namespace washfsi
