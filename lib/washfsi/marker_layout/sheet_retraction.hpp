// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/marker_layout/even_spread.hpp"
#include "washfsi/marker_layout/marker_layout.hpp"
#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// Finds the places of markers in a part of a shape that is thinner than their reach: in its middle, as a sheet, and
/// within the outline that such a sheet may fill.
template <int Dim>
class SheetRetraction {
 public:
  /// Both arguments must outlive it.
  SheetRetraction(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout) : shape_(shape), layout_(layout) {}
  /// The place that belongs to one within the part, which was found from a face with the outward normal `out`.
  Candidate<Dim> retracted(Point<Dim> place, const Point<Dim>& out) const;

 private:
  Point<Dim> to_nearest_edge(const Point<Dim>& place, const Point<Dim>& normal) const;
  double beyond_edges(double along) const;
  bool keep_within(Point<Dim>& place, const Point<Dim>& way, bool to_edge) const;
  Point<Dim> centred(const Point<Dim>& place, const Point<Dim>& normal) const;
  double extent(const Point<Dim>& place, const Point<Dim>& tangent, double most, double along) const;

  const Shape<Dim>& shape_;
  const MarkerLayout<Dim>& layout_;
};

extern template class SheetRetraction<2>;
extern template class SheetRetraction<3>;

}  // namespace washfsi
