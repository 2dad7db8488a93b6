// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "washfsi/marker_layout/sheet_retraction.hpp"

namespace washfsi {

/// Retracts markers: finds their places behind the surface of a shape, or in the middle of a part thinner than the
/// reach of its markers (`surface_markers`).
template <int Dim>
class MarkerRetraction {
 public:
  MarkerRetraction(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout)
      : shape_(shape), layout_(layout), sheet_(shape, layout), cell_(layout.cell.minCoeff()) {}
  /// The place that belongs to a seed outside the shape; none for seeds beyond reach, or where the shape's distance is
  /// no true distance.
  std::optional<Candidate<Dim>> retracted(const Point<Dim>& seed) const;
  /// The place as above if it is its own foot: in the middle of a thin part, or in a corner between parts; else none.
  std::optional<Candidate<Dim>> retracted_without_face(const Point<Dim>& seed) const;

  static constexpr double reach = 0.75;  ///< largest distance of seeds from the surface [cells]

 private:
  static constexpr double fine = 0.05, coarse = 0.4;  // steps [cells] for surfaces; across ridges of the depth
  /// The part of the shape behind the surface before a seed.
  struct Behind {
    Point<Dim> foot, normal, inmost;
    double depth, along;  ///< depth of the inmost place; a cell's size in the normal's direction [m]
  };
  std::optional<Behind> behind(const Point<Dim>& seed, double deepest) const;
  bool is_in_sheet(const Behind& behind) const { return behind.depth < behind.along * layout_.moments.sheet_reach(); }
  Candidate<Dim> on_face(const Behind& behind) const;
  bool has_no_slip_behind(const Point<Dim>& foot, const Point<Dim>& inwards) const;
  double no_slip_stress(double flat, double bend) const;
  double stirred_stress(double curvature, double along) const;
  std::optional<Point<Dim>> foot_of(const Point<Dim>& seed) const;
  std::pair<Point<Dim>, double> inmost_behind(const Point<Dim>& foot, const Point<Dim>& normal, double along,
                                              double deepest) const;
  Point<Dim> refined(const Point<Dim>& place, const Point<Dim>& way, double step) const;
  using Curvatures = Eigen::Matrix<double, Dim, Dim>;
  Curvatures curvatures(const Point<Dim>& foot) const;
  double bending(const Curvatures& curvatures) const;

  const Shape<Dim>& shape_;
  const MarkerLayout<Dim>& layout_;
  SheetRetraction<Dim> sheet_;
  double cell_;
};

extern template class MarkerRetraction<2>;
extern template class MarkerRetraction<3>;

}  // namespace washfsi
