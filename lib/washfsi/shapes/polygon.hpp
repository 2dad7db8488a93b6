// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// A closed polygon without crossings; its corners in either sense of rotation.
class Polygon : public Shape<2> {
 public:
  /// A polygon; or the profile (r, z) of a solid of revolution, whose edges on the axis r = 0 are no surface: distances
  /// are then those at r >= 0.
  enum class Kind { outline, profile };
  explicit Polygon(Points<2> vertices, Kind kind = Kind::outline);
  double distance(const Point<2>& place) const override;
  Extent<2> extent() const override;

  /// Describes why these corners form no polygon; empty if they do.
  static std::string flaw(const Points<2>& vertices);

 private:
  struct Edge {
    Point<2> from, along;
    double inverse_length2;
    bool is_surface;
  };
  std::vector<Edge> edges_;
};

}  // namespace washfsi
