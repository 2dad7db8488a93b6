// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// A solid as a signed distance [m] in its own frame: negative inside, exact outside.
template <int Dim>
class Shape {
 public:
  Shape() = default;
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  virtual ~Shape() = default;
  virtual double distance(const Point<Dim>& place) const = 0;
};

template <int Dim>
using ShapePtr = std::unique_ptr<Shape<Dim>>;

/// A circle in the plane, a ball in space, about the origin.
template <int Dim>
class Sphere : public Shape<Dim> {
 public:
  explicit Sphere(double radius) : radius_(radius) {}
  double distance(const Point<Dim>& place) const override { return place.norm() - radius_; }

 private:
  double radius_;
};

/// A hub with equal rounded vanes: the union of a circle and of capsules from the centre outwards, the first vane
/// along x. The geometry is our own; the thesis's drawing is not available.
class Vaned : public Shape<2> {
 public:
  struct Dimensions {
    double hub_radius = 0.07;      ///< [m]
    double tip_radius = 0.19;      ///< reach of the vanes from the centre [m]
    double vane_thickness = 0.04;  ///< [m]; the tips are half circles
    int vanes = 3;
  };
  explicit Vaned(const Dimensions& dimensions);
  double distance(const Point<2>& place) const override;

 private:
  Dimensions dimensions_;
  std::vector<Point<2>> directions_;  ///< of the vanes
};

/// The solid is everything outside another shape (a drum).
template <int Dim>
class Inverted : public Shape<Dim> {
 public:
  explicit Inverted(ShapePtr<Dim> inner) : inner_(std::move(inner)) {}
  double distance(const Point<Dim>& place) const override { return -inner_->distance(place); }

 private:
  ShapePtr<Dim> inner_;
};

}  // namespace washfsi
