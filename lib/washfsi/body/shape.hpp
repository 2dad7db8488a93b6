// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "washfsi/support/point.hpp"

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
};

template <int Dim>
using ShapePtr = std::unique_ptr<Shape<Dim>>;

template <int Dim>
using ShapeList = std::vector<ShapePtr<Dim>>;

}  // namespace washfsi
