// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// A circle in the plane, a ball in space, about the origin.
template <int Dim>
class Sphere : public Shape<Dim> {
 public:
  explicit Sphere(double radius) : radius_(radius) {}
  double distance(const Point<Dim>& place) const override { return place.norm() - radius_; }
  Extent<Dim> extent() const override {
    return {Bounds<Dim>::round(Point<Dim>::Zero(), Point<Dim>::Constant(radius_))};
  }

 private:
  double radius_;
};

/// A rectangle in the plane, a cuboid in space, about the origin, with sides along the axes.
template <int Dim>
class Cuboid : public Shape<Dim> {
 public:
  /// Lengths of its sides [m].
  explicit Cuboid(const Point<Dim>& size) : half_(0.5 * size) {}
  double distance(const Point<Dim>& place) const override;
  Extent<Dim> extent() const override { return {Bounds<Dim>::round(Point<Dim>::Zero(), half_)}; }

 private:
  Point<Dim> half_;
};

/// All that lies on one side of a line or plane through the origin.
template <int Dim>
class HalfSpace : public Shape<Dim> {
 public:
  /// `normal` points out of the solid; any length but 0.
  explicit HalfSpace(const Point<Dim>& normal) : normal_(normal.normalized()) {}
  double distance(const Point<Dim>& place) const override { return place.dot(normal_); }
  Extent<Dim> extent() const override;

 private:
  Point<Dim> normal_;
};

/// All that is nearer than a radius to a segment; a ball if its ends are one.
template <int Dim>
class Capsule : public Shape<Dim> {
 public:
  Capsule(const Point<Dim>& from, const Point<Dim>& to, double radius)
      : from_(from), axis_(to - from), radius_(radius) {}
  double distance(const Point<Dim>& place) const override;
  Extent<Dim> extent() const override {
    const Point<Dim> to = from_ + axis_;
    return Extent<Dim>{{from_.cwiseMin(to), from_.cwiseMax(to)}}.grown(radius_);
  }

 private:
  Point<Dim> from_, axis_;
  double radius_;
};

extern template class Cuboid<2>;
extern template class Cuboid<3>;
extern template class HalfSpace<2>;
extern template class HalfSpace<3>;
extern template class Capsule<2>;
extern template class Capsule<3>;

}  // namespace washfsi
