// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "washfsi/shapes/extent.hpp"
#include "washfsi/shapes/pose.hpp"

namespace washfsi {

/// A solid as a signed distance [m] in its own frame: negative inside. Primitives are exact everywhere; combinations
/// may be bounds where their comments say so (never beyond the true distance).
template <int Dim>
class Shape {
 public:
  Shape() = default;
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  virtual ~Shape() = default;
  virtual double distance(const Point<Dim>& place) const = 0;
  /// Its extent in its frame.
  virtual Extent<Dim> extent() const { return Extent<Dim>::infinite(); }
  /// Whether the solid is what lies outside a surface.
  virtual bool is_inverted() const { return false; }

  std::string name;  ///< prefix of the options that describe it; empty if none do

  /// A shape in its place.
  struct Part {
    const Shape* shape;
    Pose<Dim> pose;
  };
  /// Adds the shapes whose union this one is, with this place; the shape itself if it is no union.
  virtual void add_parts(const Pose<Dim>& pose, std::vector<Part>& parts) const { parts.push_back({this, pose}); }
};

/// Gradient of a shape's distance, over differences of `step` [m] to either side.
template <int Dim>
Point<Dim> distance_gradient(const Shape<Dim>& shape, const Point<Dim>& place, double step) {
  Point<Dim> gradient;
  for (int d = 0; d < Dim; ++d) {
    const Point<Dim> aside = step * Point<Dim>::Unit(d);
    gradient[d] = (shape.distance(place + aside) - shape.distance(place - aside)) / (2 * step);
  }
  return gradient;
}

template <int Dim>
using ShapePtr = std::unique_ptr<Shape<Dim>>;

template <int Dim>
using ShapeList = std::vector<ShapePtr<Dim>>;

}  // namespace washfsi
