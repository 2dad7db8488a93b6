// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// The endless shape along an axis with the cross section of another shape at one place.
template <int Dim>
class Endless : public Shape<Dim> {
 public:
  Endless(ShapePtr<Dim> inner, int axis, double place);
  double distance(const Point<Dim>& place) const override { return inner_->distance(at_place(place)); }
  Extent<Dim> extent() const override;
  void add_parts(const Pose<Dim>& pose, std::vector<typename Shape<Dim>::Part>& parts) const override;

 private:
  class EndlessPart;
  Extent<Dim> endless(Extent<Dim> extent) const;
  Point<Dim> at_place(Point<Dim> place) const {
    place[axis_] = place_;
    return place;
  }

  ShapePtr<Dim> inner_;
  int axis_;
  double place_;
  struct Part {
    ShapePtr<Dim> shape;
    Pose<Dim> pose;
  };
  std::vector<Part> parts_;  ///< parts of the inner shape, each endless
};

extern template class Endless<2>;
extern template class Endless<3>;

}  // namespace washfsi
