// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/shapes/shape.hpp"

namespace washfsi::test {

/// Points of a segment or curve, from both ends of its parameter 0..1.
template <int Dim>
Points<Dim> along(std::size_t count, const std::function<Point<Dim>(double)>& curve) {
  Points<Dim> points;
  for (std::size_t k = 0; k <= count; ++k) points.push_back(curve(static_cast<double>(k) / static_cast<double>(count)));
  return points;
}

/// Points of a closed polygon's edges.
inline Points<2> outline_of(const Points<2>& corners, std::size_t per_edge) {
  Points<2> points;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point<2> from = corners[k], step = corners[(k + 1) % corners.size()] - from;
    for (const auto& point : along<2>(per_edge, [&](double s) -> Point<2> { return from + s * step; }))
      points.push_back(point);
  }
  return points;
}

/// Length of the gradient by central differences; negative where one-sided differences tell an edge nearby.
template <int Dim>
double gradient_length(const Shape<Dim>& shape, const Point<Dim>& place) {
  constexpr double step = 1e-6;
  Point<Dim> gradient;
  const double here = shape.distance(place);
  for (int d = 0; d < Dim; ++d) {
    const Point<Dim> shift = step * Point<Dim>::Unit(d);
    const double forward = shape.distance(place + shift) - here, backward = here - shape.distance(place - shift);
    if (std::abs(forward - backward) > 1e-3 * step) return -1;
    gradient[d] = (forward + backward) / (2 * step);
  }
  return gradient.norm();
}

/// Distance zero on the surface; elsewhere that to the nearest of its points, which are `spacing` apart, with the sign
/// of the inside; and a gradient of length 1.
template <int Dim>
void expect_exact_distance(const Shape<Dim>& shape, const Points<Dim>& surface, double spacing,
                           const std::function<bool(const Point<Dim>&)>& inside, double scale = 1) {
  for (const auto& point : surface) ASSERT_NEAR(shape.distance(point), 0, 1e-14);
  int edges = 0;
  for (const auto& place : random_points<Dim>(200, 7, scale)) {
    double nearest = std::numeric_limits<double>::max();
    for (const auto& point : surface) nearest = std::min(nearest, (point - place).norm());
    const double distance = shape.distance(place);
    EXPECT_LE(std::abs(distance), nearest + 1e-12);
    EXPECT_GE(std::abs(distance), nearest - spacing);
    EXPECT_EQ(distance < 0, inside(place)) << place.transpose();
    const double gradient = gradient_length(shape, place);
    if (gradient < 0)
      ++edges;
    else
      EXPECT_NEAR(gradient, 1, 1e-6) << place.transpose();
  }
  EXPECT_LE(edges, 4);
}

}  // namespace washfsi::test
