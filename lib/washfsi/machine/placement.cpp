// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/machine/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

template <int Dim>
double point_to_segment(const Point<Dim>& p, const Segment<Dim>& s) {
  const Point<Dim> along = s.to - s.from;
  const double t = std::clamp((p - s.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - s.from - t * along).norm();
}

// Least distance of two segments in the plane; 0 if they cross.
double segment_distance(const Segment<2>& a, const Segment<2>& b) {
  const auto side = [](const Segment<2>& s, const Point<2>& p) { return cross<2>(s.to - s.from, p - s.from)[0]; };
  const bool crossing = side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
  if (crossing) return 0;
  return std::min(
      {point_to_segment(a.from, b), point_to_segment(a.to, b), point_to_segment(b.from, a), point_to_segment(b.to, a)});
}

/// Finds places for the cloths of one group after another.
template <int Dim>
class Placer {
 public:
  explicit Placer(const std::vector<Body<Dim>>& bodies) : bodies_(bodies) {}

  Segment<Dim> place(const ClothGroup<Dim>& group, const PlacementOptions<Dim>& options, PetscInt number,
                     Uniform& uniform) {
    Segment<Dim> segment;
    const double turn = 2 * std::numbers::pi / static_cast<double>(std::max<PetscInt>(group.count, 1));
    if (options.rule == "random") {
      segment = draw(group, options, uniform);
    } else if (options.rule == "radial") {
      const Point<Dim> outwards = unit(turn * static_cast<double>(number));
      segment = {options.center + options.inner_radius * outwards,
                 options.center + (options.inner_radius + group.size) * outwards};
    } else {
      const Point<Dim> along = options.direction.normalized();
      const bool stacked = options.rule == "stack";
      const double pitch = stacked ? options.distance : group.size + options.distance;
      const Point<Dim> middle =
          options.center + static_cast<double>(number) * pitch * (stacked ? turned_left<Dim>(along) : along);
      segment = {middle - 0.5 * group.size * along, middle + 0.5 * group.size * along};
    }
    placed_.push_back(segment);
    return segment;
  }

 private:
  static Point<Dim> unit(double angle) {
    Point<Dim> result = Point<Dim>::Zero();
    result.template head<2>() << std::cos(angle), std::sin(angle);
    return result;
  }
  Segment<Dim> draw(const ClothGroup<Dim>& group, const PlacementOptions<Dim>& options, Uniform& uniform) const {
    constexpr int most_tries = 1000000;
    for (int n = 0; n < most_tries; ++n) {
      const double radius = options.radius * std::sqrt(uniform());
      const Point<Dim> middle = options.center + radius * unit(2 * std::numbers::pi * uniform());
      const Point<Dim> half = 0.5 * group.size * unit(std::numbers::pi * uniform());
      Segment<Dim> segment{middle - half, middle + half};
      if (is_free(segment, options)) return segment;
    }
    throw InputError("-" + group.name + "_placement random: no free place for a cloth after " +
                     std::to_string(most_tries) + " tries; use fewer or shorter cloths or a smaller -" + group.name +
                     "_clearance");
  }

  bool is_free(const Segment<Dim>& segment, const PlacementOptions<Dim>& options) const {
    const Point<Dim> along = segment.to - segment.from;
    for (double walked = 0; walked <= 1;) {  // sphere tracing: what a distance exceeds the clearance by lies free ahead
      const double distance = nearest_distance<Dim>(bodies_, segment.from + walked * along, 0.0);
      if (distance < options.clearance) return false;
      walked += std::max(distance - options.clearance, 0.02 * options.clearance) / along.norm();
    }
    if (nearest_distance<Dim>(bodies_, segment.to, 0.0) < options.clearance) return false;
    for (const auto& end : {segment.from, segment.to})
      if ((end - options.center).norm() > options.radius) return false;
    if constexpr (Dim == 2)
      return std::all_of(placed_.begin(), placed_.end(), [&](const Segment<2>& other) {
        return segment_distance(segment, other) >= options.clearance;
      });
    return true;
  }

  const std::vector<Body<Dim>>& bodies_;
  std::vector<Segment<Dim>> placed_;
};

template <int Dim>
void check_start(const ClothGroup<Dim>& group, const std::vector<Body<Dim>>& bodies, const Point<Dim>& place,
                 const Point<Dim>& lower, const Point<Dim>& upper) {
  std::string where = "outside the grid";
  bool bad = !((place - lower).minCoeff() > 0 && (upper - place).minCoeff() > 0);
  for (const auto& body : bodies)
    if (!bad && body.distance(place, 0.0) <= 0) {
      bad = true;
      where = "inside the solid of body " + body.name;
    }
  if (!bad) return;
  throw InputError("-" + group.name + "_placement: a cloth starts " + where + ", at (" + list_text<Dim>(place) +
                   ") m; cloths must start in the water");
}

}  // namespace

template <int Dim>
PlacementOptions<Dim> PlacementOptions<Dim>::from_options(Options& options, const std::string& group) {
  PlacementOptions<Dim> placement;
  options.block(group + "_", "Placement of " + group, [&](OptionBlock& block) {
    block.choice("placement", placement.rule, {"line", "stack", "radial", "random"},
                 "rule by which the cloths are placed");
    block.template point<Dim>("center", placement.center, "m",
                              "centre of the first cloth (line, stack), of the fan (radial), of the disc (random)");
    block.template point<Dim>("direction", placement.direction, "-", "direction of the cloths (line, stack)");
    block.real("distance", placement.distance, "m", non_negative, "between neighbours (line, stack)");
    block.real("inner_radius", placement.inner_radius, "m", non_negative, "where the cloths begin (radial)");
    block.real("radius", placement.radius, "m", positive, "of the disc that holds the cloths (random)");
    block.real("clearance", placement.clearance, "m", positive, "least distance from bodies and other cloths (random)");
    block.integer("seed", placement.seed, non_negative_integer, "of the random placement and of crumpled cloth");
  });
  placement.shape = ShapeOptions<Dim>::from_options(options, group);
  if (placement.direction.norm() == 0) throw InputError("-" + group + "_direction: must not be zero");
  return placement;
}

template <int Dim>
Points<Dim> place_cloths(const Cloths<Dim>& cloths, const std::vector<PlacementOptions<Dim>>& placements,
                         const std::vector<Body<Dim>>& bodies, const Point<Dim>& lower, const Point<Dim>& upper) {
  Points<Dim> positions;
  Placer<Dim> placer(bodies);
  for (std::size_t g = 0; g < cloths.groups().size(); ++g) {
    const ClothGroup<Dim>& group = cloths.groups()[g];
    Uniform uniform(placements[g].seed);
    for (PetscInt number = 0; number < group.count; ++number) {
      const Segment<Dim> segment = placer.place(group, placements[g], number, uniform);
      for (const Point<Dim>& place : shaped_cloth<Dim>(group, placements[g].shape, segment, uniform)) {
        check_start<Dim>(group, bodies, place, lower, upper);
        positions.push_back(place);
      }
    }
  }
  return positions;
}

template struct PlacementOptions<2>;
template struct PlacementOptions<3>;
template Points<2> place_cloths<2>(const Cloths<2>&, const std::vector<PlacementOptions<2>>&,
                                   const std::vector<Body<2>>&, const Point<2>&, const Point<2>&);
template Points<3> place_cloths<3>(const Cloths<3>&, const std::vector<PlacementOptions<3>>&,
                                   const std::vector<Body<3>>&, const Point<3>&, const Point<3>&);

}  // namespace washfsi
