// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>

#include "washfsi/grid/grid.hpp"
#include "washfsi/immersed_boundary/delta.hpp"

namespace washfsi {

/// The faces within the delta of one marker, of all velocity components: weights along each axis, whose products are
/// those of the faces.
template <int Dim, class Axis = AxisStencil>
class FaceStencil {
 public:
  /// An empty stencil, of no marker.
  FaceStencil() = default;
  FaceStencil(const Grid<Dim>& grid, const AxisDelta& delta, const Point<Dim>& position) {
    for (int d = 0; d < Dim; ++d) {
      const double place = (position[d] - grid.lower()[d]) / grid.spacing()[d];
      axes_[d] = {of_kind(delta.stencil(place)), of_kind(delta.stencil(place - 0.5))};
    }
  }

  /// Weights along an axis of the faces of a component: those normal to the axis or those between.
  const Axis& along(int axis, int component) const { return axes_[axis][axis == component ? 0 : 1]; }

  /// Whether some of its faces lie in sides of a box of `cells` cells or beyond them; adds these sides, by axis and
  /// end, to `sides`.
  bool find_reached(const Index<Dim>& cells, std::array<std::array<bool, 2>, Dim>& sides) const {
    bool any = false;
    for (int d = 0; d < Dim; ++d)
      for (const Axis& faces : axes_[d]) {
        const bool lower = faces.first<1, upper = faces.first + faces.count> cells[d];
        sides[d][0] = sides[d][0] || lower;
        sides[d][1] = sides[d][1] || upper;
        any = any || lower || upper;
      }
    return any;
  }

  /// The means of each component's faces by their weights.
  Point<Dim> mean(const ConstFaceView<Dim>& field) const {
    Point<Dim> means;
    for_each_component<Dim>([&](auto c) { means[c] = mean(c, field); });
    return means;
  }
  /// The mean of one component's faces by their weights.
  double mean(auto component, const ConstFaceView<Dim>& field) const {
    const Axis& x = along(0, component);
    double mean = 0;
    with_count(x.count, [&](auto count) {
      std::array<double, Dim * Axis::most> sums{};  // over rows, with what lies between: whole vectors
      visit_rows(component, field, [&](const double* row, double weight) {
        for (int i = 0; i <= Dim * (count - 1); ++i) sums[i] += weight * row[i];
      });
      for (int i = 0; i < count; ++i) mean += sums[i * Dim] * x.weight[i];
    });
    return mean;
  }

  /// Adds to a component's faces a value times their weights.
  void add(auto component, double value, const FaceView<Dim>& field) const {
    const Axis& x = along(0, component);
    with_count(x.count, [&](auto count) {
      std::array<double, Dim * Axis::most> values{};  // with nothing for what lies between: whole vectors
      for (int i = 0; i < count; ++i) values[i * Dim] = value * x.weight[i];
      visit_rows(component, field, [&](double* row, double weight) {
        for (int i = 0; i <= Dim * (count - 1); ++i) row[i] += weight * values[i];
      });
    });
  }

  /// Calls visit(row, weight) for each row along x of a component's faces, `row` pointing to its first face in the
  /// field of a view; the weight of the row times that along x is a face's.
  template <class Field, class Visit>
  void visit_rows(int component, const Field& field, const Visit& visit) const {
    Index<Dim> first;
    for (int d = 0; d < Dim; ++d) first[d] = along(d, component).first;
    visit_from<Dim - 1>(component, field, &field(first, component), 1.0, visit);
  }

 private:
  static Axis of_kind(const AxisStencil& stencil) {
    Axis result;
    result.first = stencil.first;
    result.count = std::min(stencil.count, Axis::most);
    std::copy_n(stencil.weight.begin(), result.count, result.weight.begin());
    return result;
  }

  template <int Number, class Field, class Pointer, class Visit>
  void visit_from(int component, const Field& field, Pointer face, double weight, const Visit& visit) const {
    if constexpr (Number == 0) {
      visit(face, weight);
    } else {
      const auto& stencil = along(Number, component);
      for (int i = 0; i < stencil.count; ++i, face += field.stride(Number))
        visit_from<Number - 1>(component, field, face, weight * stencil.weight[i], visit);
    }
  }

  std::array<std::array<Axis, 2>, Dim> axes_;
};

}  // namespace washfsi
