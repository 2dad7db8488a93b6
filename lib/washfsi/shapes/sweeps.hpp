// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// A plane shape made solid along z, from -height/2 to height/2. Exact where the outline's distance is exact.
class Extruded : public Shape<3> {
 public:
  Extruded(ShapePtr<2> outline, double height) : outline_(std::move(outline)), half_height_(0.5 * height) {}

  double distance(const Point<3>& place) const override {
    const double beyond_outline = outline_->distance(place.head<2>());
    const double beyond_ends = std::abs(place[2]) - half_height_;
    return std::hypot(std::max(beyond_outline, 0.0), std::max(beyond_ends, 0.0)) +
           std::min(std::max(beyond_outline, beyond_ends), 0.0);
  }
  Extent<3> extent() const override {
    const auto [plan, of_opening] = outline_->extent();
    Extent<3> result = Extent<3>::infinite();
    if (!of_opening) result.bounds.lower << plan.lower, -half_height_;
    if (!of_opening) result.bounds.upper << plan.upper, half_height_;
    return result;
  }

 private:
  ShapePtr<2> outline_;
  double half_height_;
};

/// A profile in the half plane (r >= 0, z) turned about z. Exact where the profile's distance is exact there, since the
/// nearest point of the surface lies in the half plane of the place.
class Revolved : public Shape<3> {
 public:
  explicit Revolved(ShapePtr<2> profile) : profile_(std::move(profile)) {}
  double distance(const Point<3>& place) const override {
    return profile_->distance({place.head<2>().norm(), place[2]});
  }
  Extent<3> extent() const override {
    const Bounds<2> profile = profile_->extent().bounds;
    const double radius = profile.upper[0];
    return {{{-radius, -radius, profile.lower[1]}, {radius, radius, profile.upper[1]}}};
  }

 private:
  ShapePtr<2> profile_;
};

}  // namespace washfsi
