// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/agitator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/geometry/nearest.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/polygon.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/sampled.hpp"
#include "washfsi/shapes/sweeps.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

/// All that is nearer than a radius to a ribbon that stands on a line in the plane z = 0.
class Ribbon : public Shape<3> {
 public:
  Ribbon(Points<2> line, double height, double radius) : line_(std::move(line)), height_(height), radius_(radius) {}

  double distance(const Point<3>& place) const override {
    const Point<2> plan = place.head<2>();
    double nearest2 = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < line_.size(); ++k)
      nearest2 = std::min(nearest2, way_from_segment<2>(line_[k], line_[k + 1] - line_[k], plan).squaredNorm());
    const double beyond_ends = std::max({place[2] - height_, -place[2], 0.0});
    return std::sqrt(nearest2 + beyond_ends * beyond_ends) - radius_;
  }

 private:
  Points<2> line_;
  double height_, radius_;
};

// The vane's line from the axis to where the radius plus half the thickness is the tip's radius.
Points<2> plan_of_vane(const AgitatorDimensions& dimensions) {
  constexpr int parts = 40;
  const double reach = dimensions.tip_radius - 0.5 * dimensions.vane_thickness;
  Points<2> line{Point<2>::Zero()};
  for (int k = 1; k <= parts; ++k) {
    const double x = static_cast<double>(k) / parts;
    const double y = ((dimensions.curve[2] * x + dimensions.curve[1]) * x + dimensions.curve[0]) * x;
    const Point<2> next = dimensions.tip_radius * Point<2>(x, y);
    if (next.norm() >= reach) {
      const double before = line.back().norm(), part = (reach - before) / (next.norm() - before);
      line.push_back(line.back() + part * (next - line.back()));
      break;
    }
    line.push_back(next);
  }
  return line;
}

Points<2> profile_of_dome(const AgitatorDimensions& dimensions) {
  constexpr int parts = 30;
  const double below = -dimensions.dome_height;  // it stands on the floor: no water beneath
  Points<2> profile{{0, below}, {dimensions.dome_radius, below}};
  for (int k = parts; k >= 0; --k) {
    const double part = static_cast<double>(k) / parts;
    profile.emplace_back(dimensions.dome_radius * part, dimensions.dome_height * (1 - part * part));
  }
  return profile;
}

}  // namespace

ShapePtr<3> agitator(const AgitatorDimensions& dimensions) {
  const double half_thickness = 0.5 * dimensions.vane_thickness;
  const Point<3> top(0, 0, dimensions.post_height - dimensions.post_radius);
  auto vane =
      std::make_unique<Ribbon>(plan_of_vane(dimensions), dimensions.vane_height - half_thickness, half_thickness);
  ShapeList<3> parts;
  parts.push_back(std::make_unique<Capsule<3>>(Point<3>::Zero(), top, dimensions.post_radius));
  parts.push_back(
      std::make_unique<Revolved>(std::make_unique<Polygon>(profile_of_dome(dimensions), Polygon::Kind::profile)));
  parts.push_back(std::make_unique<Repeated<3>>(std::move(vane), dimensions.vanes));
  return std::make_unique<Union<3>>(std::move(parts));
}

ShapePtr<3> sampled_agitator(MPI_Comm comm, const AgitatorDimensions& dimensions, double spacing,
                             const std::string& name) {
  const double radius = std::max({dimensions.dome_radius, dimensions.tip_radius, dimensions.post_radius});
  const double height = std::max({dimensions.dome_height, dimensions.vane_height, dimensions.post_height});
  const Point<3> lower(-radius, -radius, -dimensions.dome_height), upper(radius, radius, height);
  const ShapePtr<3> exact = agitator(dimensions);
  const auto lattice = Lattice<3>::around(lower, upper, 4 * spacing, spacing);
  if (lattice.size() > Lattice<3>::most_points)
    throw InputError("-" + name + "_shape agitator, " + to_text(2 * radius) + " m wide and " + to_text(height) +
                     " m high: too large for cells this small; its distance would be kept at " +
                     to_text(lattice.size()) + " points");
  return Sampled<3>::of(comm, *exact, lattice);
}

}  // namespace washfsi
