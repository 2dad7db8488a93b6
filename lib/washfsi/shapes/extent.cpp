// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/extent.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

template <int Dim>
Bounds<Dim> common(const Bounds<Dim>& a, const Bounds<Dim>& b) {
  Bounds<Dim> both{a.lower.cwiseMax(b.lower), a.upper.cwiseMin(b.upper)};
  both.upper = both.upper.cwiseMax(both.lower);  // a point if they are disjoint
  return both;
}

}  // namespace

template <int Dim>
Extent<Dim> Extent<Dim>::infinite() {
  return {{Point<Dim>::Constant(-unbounded), Point<Dim>::Constant(unbounded)}};
}

template <int Dim>
bool Extent<Dim>::is_finite(int axis) const {
  return std::isfinite(bounds.lower[axis]) && std::isfinite(bounds.upper[axis]);
}

template <int Dim>
Extent<Dim> Extent<Dim>::grown(double radius) const {
  Extent result = *this;
  const double beyond = of_opening ? 0 : radius;
  result.bounds.lower.array() -= beyond;
  result.bounds.upper.array() += beyond;
  return result;
}

// The box round a box turned about z. Without bounds along x or y there are none along either.
template <int Dim>
Extent<Dim> Extent<Dim>::in_space(const Pose<Dim>& pose) const {
  Extent result = *this;
  if (pose.sine == 0 && pose.cosine == 1) {
    result.bounds.lower += pose.center;
    result.bounds.upper += pose.center;
    return result;
  }
  const Point<2> middle = 0.5 * (bounds.lower + bounds.upper).template head<2>();
  const Point<2> half = 0.5 * (bounds.upper - bounds.lower).template head<2>();
  Point<2> center = pose.center.template head<2>(), turned = Point<2>::Constant(unbounded);
  if (is_finite(0) && is_finite(1)) {
    const double c = pose.cosine, s = pose.sine;
    center += Point<2>(c * middle[0] - s * middle[1], s * middle[0] + c * middle[1]);
    turned << std::abs(c) * half[0] + std::abs(s) * half[1], std::abs(s) * half[0] + std::abs(c) * half[1];
  }
  result.bounds.lower.template head<2>() = center - turned;
  result.bounds.upper.template head<2>() = center + turned;
  if constexpr (Dim == 3) {
    result.bounds.lower[2] += pose.center[2];
    result.bounds.upper[2] += pose.center[2];
  }
  return result;
}

// The opening of a union is the intersection of the parts' openings.
template <int Dim>
Extent<Dim> Extent<Dim>::of_union(const std::vector<Extent>& parts) {
  Extent result = parts.front();
  for (const Extent& part : parts) {
    if (part.of_opening && !result.of_opening)
      result = part;
    else if (part.of_opening)
      result.bounds = common(result.bounds, part.bounds);
    else if (!result.of_opening)
      result.bounds.include(part.bounds);
  }
  return result;
}

// The opening of an intersection is the union of the parts' openings.
template <int Dim>
Extent<Dim> Extent<Dim>::of_intersection(std::vector<Extent> parts) {
  for (Extent& part : parts) part = part.inverted();
  return of_union(parts).inverted();
}

template struct Extent<2>;
template struct Extent<3>;

}  // namespace washfsi
