// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/placement/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "washfsi/grid/index.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

const ChoiceNames<PlacementRule>& names_of(PlacementRule) {
  static const ChoiceNames<PlacementRule> names{{"line", PlacementRule::line},
                                                {"stack", PlacementRule::stack},
                                                {"radial", PlacementRule::radial},
                                                {"random", PlacementRule::random}};
  return names;
}

namespace {

template <int Dim>
Point<Dim> unit(double angle) {
  Point<Dim> result = Point<Dim>::Zero();
  result.template head<2>() << std::cos(angle), std::sin(angle);
  return result;
}

// Orthonormal axes of a cloth from the direction of its s and, in space, an approximate direction of its r.
Eigen::Matrix2d axes_from(const Point<2>& along, const Point<2>&) {
  Eigen::Matrix2d axes;
  axes << along.normalized(), turned_left<2>(along.normalized());
  return axes;
}

Eigen::Matrix3d axes_from(const Point<3>& along, const Point<3>& across) {
  const Point<3> s = along.normalized(), normal = s.cross(across).normalized();
  Eigen::Matrix3d axes;
  axes << s, normal.cross(s), normal;
  return axes;
}

Eigen::Matrix2d random_axes(const FlatCloth<2>&, Uniform& uniform) {
  return axes_from(unit<2>(std::numbers::pi * uniform()), {});
}

// Uniformly distributed rotations (Shoemake 1992).
Eigen::Matrix3d random_axes(const FlatCloth<3>&, Uniform& uniform) {
  const double u = uniform(), a = 2 * std::numbers::pi * uniform(), b = 2 * std::numbers::pi * uniform();
  const double below = std::sqrt(1 - u), above = std::sqrt(u);
  return Eigen::Quaterniond(above * std::cos(b), below * std::sin(a), below * std::cos(a), above * std::sin(b))
      .toRotationMatrix();
}

Eigen::Matrix2d small_turn(const Point<2>& angles) {
  return Eigen::Rotation2Dd(angles[0]).toRotationMatrix();
}

Eigen::Matrix3d small_turn(const Point<3>& angles) {
  return Eigen::AngleAxisd(angles.norm(), angles.norm() > 0 ? Point<3>(angles.normalized()) : Point<3>::UnitX())
      .toRotationMatrix();
}

/// Finds places for the cloths of one group after another.
template <int Dim>
class Placer {
 public:
  Placer(const std::vector<Body<Dim>>& bodies, const PeriodicSpace<Dim>& space) : bodies_(bodies), space_(space) {}

  FlatCloth<Dim> place(const ClothGroup<Dim>& group, const PlacementOptions<Dim>& options, PetscInt number,
                       Uniform& uniform) {
    FlatCloth<Dim> cloth;
    for (int d = 0; d < Dim - 1; ++d) cloth.half[d] = 0.5 * group.size[d];
    if (options.rule == PlacementRule::random)
      cloth = draw(cloth, group, options, uniform);
    else if (options.rule == PlacementRule::radial)
      cloth = fin(cloth, options, static_cast<double>(number) / static_cast<double>(group.count), uniform);
    else
      cloth = in_a_row(cloth, options, static_cast<double>(number));
    placed_.push_back(cloth);
    return cloth;
  }

 private:
  static FlatCloth<Dim> in_a_row(FlatCloth<Dim> cloth, const PlacementOptions<Dim>& options, double number) {
    cloth.axes = axes_from(options.direction, options.across);
    const bool stacked = options.rule == PlacementRule::stack;
    const double pitch = stacked ? options.distance : 2 * cloth.half[0] + options.distance;
    cloth.middle = options.center + number * pitch * (stacked ? cloth.normal() : cloth.along());
    return cloth;
  }

  static FlatCloth<Dim> fin(FlatCloth<Dim> cloth, const PlacementOptions<Dim>& options, double part, Uniform& uniform) {
    const Point<Dim> outwards = unit<Dim>(2 * std::numbers::pi * part);
    cloth.axes = axes_from(outwards, Point<Dim>::Unit(Dim - 1));
    cloth.middle = options.center + (options.inner_radius + cloth.half[0]) * outwards;
    Point<Dim> shift, turn;
    for (int d = 0; d < Dim; ++d) shift[d] = options.shift * (2 * uniform() - 1);
    for (int d = 0; d < Dim; ++d) turn[d] = options.tilt * (2 * uniform() - 1);
    cloth.middle += shift;
    cloth.axes = small_turn(turn) * cloth.axes;
    return cloth;
  }

  FlatCloth<Dim> draw(FlatCloth<Dim> cloth, const ClothGroup<Dim>& group, const PlacementOptions<Dim>& options,
                      Uniform& uniform) const {
    constexpr int most_tries = 1000000;
    for (int n = 0; n < most_tries; ++n) {
      const double radius = options.radius * std::sqrt(uniform());
      cloth.middle = options.center + radius * unit<Dim>(2 * std::numbers::pi * uniform());
      if constexpr (Dim == 3) cloth.middle[2] += options.height * (uniform() - 0.5);
      cloth.axes = random_axes(cloth, uniform);
      if (is_free(cloth, options)) return cloth;
    }
    throw InputError("-" + group.name + "_placement random: no free place for a cloth after " +
                     std::to_string(most_tries) + " tries; use fewer or shorter cloths or a smaller -" + group.name +
                     "_clearance");
  }

  bool is_free(const FlatCloth<Dim>& cloth, const PlacementOptions<Dim>& options) const {
    if (!is_within(cloth, options)) return false;
    const bool clear_of_cloths = std::all_of(placed_.begin(), placed_.end(), [&](const FlatCloth<Dim>& other) {
      return distance_of_images(cloth, other) >= options.clearance;
    });
    return clear_of_cloths && is_clear_of_bodies(cloth, options.clearance);
  }

  // Distance of a cloth from the images of another.
  double distance_of_images(const FlatCloth<Dim>& cloth, const FlatCloth<Dim>& other) const {
    Box<Dim> images{};
    FlatCloth<Dim> nearest = other;
    for (int d = 0; d < Dim; ++d) {
      images.lower[d] = space_.periodic[d] ? -1 : 0;
      images.upper[d] = 1 - images.lower[d];
      if (!space_.periodic[d]) continue;
      const double apart = (other.middle[d] - cloth.middle[d]) / space_.length[d];
      nearest.middle[d] -= space_.length[d] * std::floor(apart + 0.5);
    }
    double least = std::numeric_limits<double>::infinity();
    for_each<Dim>(images, [&](const Index<Dim>& number) {
      FlatCloth<Dim> image = nearest;
      for (int d = 0; d < Dim; ++d) image.middle[d] += static_cast<double>(number[d]) * space_.length[d];
      least = std::min(least, distance(cloth, image));
    });
    return least;
  }

  // Whether all corners lie in the disc.
  static bool is_within(const FlatCloth<Dim>& cloth, const PlacementOptions<Dim>& options) {
    for (int corner = 0; corner < 1 << (Dim - 1); ++corner) {
      typename FlatCloth<Dim>::Coordinates place;
      for (int d = 0; d < Dim - 1; ++d) place[d] = (corner >> d) % 2 == 0 ? -1 : 1;
      const Point<Dim> arm = cloth.at(place) - options.center;
      if (arm.template head<2>().norm() > options.radius) return false;
      if (Dim == 3 && std::abs(arm[Dim - 1]) > 0.5 * options.height) return false;
    }
    return true;
  }

  // Tests along lines no farther apart than half the clearance.
  bool is_clear_of_bodies(const FlatCloth<Dim>& cloth, double clearance) const {
    typename FlatCloth<Dim>::Coordinates place;
    if constexpr (Dim == 2) return is_line_clear(cloth, place, clearance);
    const int lines = 1 + static_cast<int>(std::ceil(4 * cloth.half[Dim - 2] / clearance));
    for (int line = 0; line < lines; ++line) {
      place[Dim - 2] = -1 + 2.0 * line / (lines - 1);
      if (!is_line_clear(cloth, place, clearance)) return false;
    }
    return true;
  }

  // Sphere tracing: what a distance exceeds the clearance by lies free ahead.
  bool is_line_clear(const FlatCloth<Dim>& cloth, typename FlatCloth<Dim>::Coordinates place, double clearance) const {
    for (place[0] = -1; place[0] <= 1;) {
      const double free = nearest_distance<Dim>(bodies_, cloth.at(place), 0.0) - clearance;
      if (free < 0) return false;
      place[0] += std::max(free, 0.02 * clearance) / cloth.half[0];
    }
    place[0] = 1;
    return nearest_distance<Dim>(bodies_, cloth.at(place), 0.0) >= clearance;
  }

  const std::vector<Body<Dim>>& bodies_;
  PeriodicSpace<Dim> space_;
  std::vector<FlatCloth<Dim>> placed_;
};

template <int Dim>
void check_start(const ClothGroup<Dim>& group, const std::vector<Body<Dim>>& bodies, const Point<Dim>& place,
                 const PeriodicSpace<Dim>& space) {
  std::string where = "outside the grid";
  bool bad = false;
  for (int d = 0; d < Dim; ++d) {
    const double from_lower = place[d] - space.lower[d];
    bad = bad || (!space.periodic[d] && !(from_lower > 0 && from_lower < space.length[d]));
  }
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

namespace {

// Marks the options that the rule of placement does not use.
template <int Dim>
void mark_unused(Options& options, const std::string& group, const PlacementOptions<Dim>& placement) {
  const auto unless = [&](const std::vector<PlacementRule>& rules, const std::vector<std::string>& names) {
    if (std::ranges::find(rules, placement.rule) != rules.end()) return;
    for (const std::string& name : names)
      options.mark_idle("-" + group + "_placement is " + name_of(placement.rule), {group + "_" + name});
  };
  using enum PlacementRule;
  unless({line, stack}, {"direction", "across", "distance"});
  unless({radial}, {"inner_radius", "shift", "tilt"});
  unless({random}, {"radius", "height", "clearance"});
}

}  // namespace

template <int Dim>
PlacementOptions<Dim> PlacementOptions<Dim>::from_options(Options& options, const std::string& group) {
  constexpr Range half_turn{0.0, std::numbers::pi, false, "a number from 0 to pi"};
  PlacementOptions<Dim> placement;
  options.block(
      group + "_", "Placement of " + group,
      [&](OptionBlock& block) {
        block.choice("placement", placement.rule, "rule by which the cloths are placed");
        block.template point<Dim>("center", placement.center, "m",
                                  "centre of the first cloth (line, stack), of the fan (radial), of the disc (random)");
        block.template point<Dim>("direction", placement.direction, "-", "direction of the cloths' s (line, stack)");
        if (Dim == 3)
          block.template point<Dim>("across", placement.across, "-", "direction of the cloths' r (line, stack)");
        block.real("distance", placement.distance, "m", non_negative,
                   "between neighbours; 0: end to end (line), all in one place (stack)");
        block.real("inner_radius", placement.inner_radius, "m", non_negative,
                   "where the cloths begin; 0: at the centre of the fan (radial)");
        block.real("shift", placement.shift, "m", non_negative,
                   "largest random shift of a cloth along each axis; 0: none (radial)");
        block.real("tilt", placement.tilt, "rad", half_turn,
                   "largest random turn of a cloth about each axis; 0: none (radial)");
        block.real("radius", placement.radius, "m", positive, "of the disc that holds the cloths (random)");
        if (Dim == 3)
          block.real("height", placement.height, "m", positive, "of the disc that holds the cloths (random)");
        block.real("clearance", placement.clearance, "m", positive,
                   "least distance from bodies and other cloths (random)");
        block.integer("seed", placement.seed, non_negative_integer,
                      "of the random placement, of shift and tilt and of crumpled cloth");
      },
      "cloths_");
  placement.shape = ShapeOptions<Dim>::from_options(options, group);
  mark_unused(options, group, placement);
  if (placement.direction.norm() == 0) throw InputError("-" + group + "_direction: must not be zero");
  if (Dim == 3 && cross<Dim>(placement.direction, placement.across).norm() == 0)
    throw InputError("-" + group + "_across: must not be zero or parallel to -" + group + "_direction");
  return placement;
}

template <int Dim>
Points<Dim> place_cloths(const Cloths<Dim>& cloths, const std::vector<PlacementOptions<Dim>>& placements,
                         const std::vector<Body<Dim>>& bodies, const PeriodicSpace<Dim>& space) {
  Points<Dim> positions;
  Placer<Dim> placer(bodies, space);
  for (std::size_t g = 0; g < cloths.groups().size(); ++g) {
    const ClothGroup<Dim>& group = cloths.groups()[g];
    Uniform uniform(placements[g].seed);
    for (PetscInt number = 0; number < group.count; ++number) {
      const FlatCloth<Dim> flat = placer.place(group, placements[g], number, uniform);
      for (const Point<Dim>& place : shaped_cloth<Dim>(group, placements[g].shape, flat, uniform)) {
        check_start<Dim>(group, bodies, place, space);
        positions.push_back(place);
      }
    }
  }
  return positions;
}

template struct PlacementOptions<2>;
template struct PlacementOptions<3>;
template Points<2> place_cloths<2>(const Cloths<2>&, const std::vector<PlacementOptions<2>>&,
                                   const std::vector<Body<2>>&, const PeriodicSpace<2>&);
template Points<3> place_cloths<3>(const Cloths<3>&, const std::vector<PlacementOptions<3>>&,
                                   const std::vector<Body<3>>&, const PeriodicSpace<3>&);

}  // namespace washfsi
