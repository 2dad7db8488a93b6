// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/shape_options.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "washfsi/shapes/agitator.hpp"
#include "washfsi/shapes/combinations.hpp"
#include "washfsi/shapes/polygon.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/shapes/stl_shape.hpp"
#include "washfsi/shapes/sweeps.hpp"
#include "washfsi/shapes/vaned.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

constexpr Range copies{1.0, 1000.0, false, "a whole number from 1 to 1000"};

enum class ShapeKind {
  sphere,
  box,
  cylinder,
  halfspace,
  capsule,
  polygon,
  revolution,
  vaned,
  agitator,
  stl,
  united,
  intersection,
  difference,
};

const ChoiceNames<ShapeKind>& names_of(ShapeKind) {
  using enum ShapeKind;
  static const ChoiceNames<ShapeKind> names{
      {"sphere", sphere},         {"box", box},         {"cylinder", cylinder},     {"halfspace", halfspace},
      {"capsule", capsule},       {"polygon", polygon}, {"revolution", revolution}, {"vaned", vaned},
      {"agitator", agitator},     {"stl", stl},         {"union", united},          {"intersection", intersection},
      {"difference", difference},
  };
  return names;
}

/// Reads the shape whose options have one prefix, without its parts.
template <int Dim>
class ShapeReader {
 public:
  ShapeReader(Options& options, std::string name, double sample_spacing, const std::string& fallback)
      : options_(options), name_(std::move(name)) {
    stl_.sample_spacing = sample_spacing_ = sample_spacing;
    options_.block(
        name_ + "_", "Shape " + name_, [&](OptionBlock& block) { read(block); }, fallback);
  }

  const std::vector<std::string>& parts() const { return parts_; }

  /// The shape in its parent's frame, of its parts if it is a combination.
  ShapePtr<Dim> build(ShapeList<Dim> parts) const {
    return in_place(named(parts.empty() ? primitive() : combination(std::move(parts))));
  }

 private:
  void read(OptionBlock& block) {
    block.choice("shape", kind_, "kind of shape; sphere is a circle in the plane", kinds());
    read_round(block);
    read_straight(block);
    read_outlines(block);
    const bool is_agitator = Dim == 3 && kind_ == ShapeKind::agitator;
    if (is_agitator) read_agitator(block);  // first: -help shows the first of options of one name
    if (used({ShapeKind::vaned})) read_vaned(block);
    if (Dim == 3 && !is_agitator && used({ShapeKind::agitator})) read_agitator(block);
    if (Dim == 3 && used({ShapeKind::stl})) stl_.read(block);
    if (used(combinations)) {
      block.require("parts", "the names of the parts of the shape");
      block.names("parts", parts_, "names of the parts (union, intersection, difference: the first minus the others)");
      if (parts_.empty() && !options_.help()) refuse("parts", "", "at least one name");
    }
    read_place(block);
    if (!block.given("shape") && !block.given("radius")) block.require("shape", "the kind of shape that it is");
  }

  void read_round(OptionBlock& block) {
    if (used({ShapeKind::cylinder, ShapeKind::capsule})) block.require("radius", "the radius of the shape [m]");
    if (used({ShapeKind::sphere, ShapeKind::cylinder, ShapeKind::capsule}))
      block.real("radius", radius_, "m", positive, "radius (sphere, cylinder, capsule)");
    if (used({ShapeKind::capsule})) {
      block.require("from", "the beginning of the capsule's axis [m]");
      block.require("to", "the end of the capsule's axis [m]");
      block.template point<Dim>("from", from_, "m", "beginning of the axis (capsule)");
      block.template point<Dim>("to", to_, "m", "end of the axis (capsule)");
    }
  }

  void read_straight(OptionBlock& block) {
    if (used({ShapeKind::box})) {
      block.require("size", "the lengths of the box's sides [m]");
      block.template point<Dim>("size", size_, "m", "lengths of the sides (box)");
      if (!(size_.minCoeff() > 0)) refuse("size", list_text<Dim>(size_), "numbers > 0");
    }
    if (used({ShapeKind::halfspace})) {
      block.require("normal", "the direction out of the solid");
      block.template point<Dim>("normal", normal_, "-", "direction out of the solid (halfspace)");
      if (!(normal_.norm() > 0)) refuse("normal", list_text<Dim>(normal_), "a direction other than 0");
    }
    if (Dim == 3 && used({ShapeKind::cylinder, ShapeKind::polygon, ShapeKind::vaned})) {
      block.require("height", "the length of the shape along z [m]");
      block.real("height", height_, "m", positive,
                 "length along z, half of it on either side (cylinder, polygon, vaned)");
    }
  }

  void read_outlines(OptionBlock& block) {
    if (used({ShapeKind::polygon}))
      corners_ = read_corners(block, "vertices", "corners x1,y1,x2,y2,... in order (polygon)");
    if (Dim == 3 && used({ShapeKind::revolution})) {
      corners_ = read_corners(block, "profile", "corners r1,z1,r2,z2,... of the profile, in order (revolution)");
      for (const auto& corner : corners_)
        if (corner[0] < 0) refuse("profile", text_of(corners_), "r1,z1,r2,z2,... with every r >= 0");
    }
  }

  Points<2> read_corners(OptionBlock& block, const std::string& option, const char* meaning) {
    std::vector<double> numbers;
    block.require(option, meaning);
    block.reals(option, numbers, 0, std::numeric_limits<std::size_t>::max(), "m", meaning);
    Points<2> corners;
    for (std::size_t k = 0; k + 1 < numbers.size(); k += 2) corners.emplace_back(numbers[k], numbers[k + 1]);
    if (options_.help()) return corners;
    if (numbers.size() % 2)
      refuse(option, text_of(corners) + "," + to_text(numbers.back()), "an even count of numbers");
    const std::string flaw = Polygon::flaw(corners);
    if (!flaw.empty()) refuse(option, text_of(corners), "the corners of a polygon without crossings, but " + flaw);
    return corners;
  }

  void read_vaned(OptionBlock& block) {
    PetscInt vanes = vaned_.vanes;
    block.real("hub_radius", vaned_.hub_radius, "m", positive, "radius of the hub (vaned)");
    block.real("tip_radius", vaned_.tip_radius, "m", positive,
               "reach of the vanes from the centre (vaned, and agitator, where the default is 0.16)");
    block.real("vane_thickness", vaned_.vane_thickness, "m", positive,
               "thickness of a vane (vaned, and agitator, where the default is 0.025)");
    block.integer("vanes", vanes, copies, "number of vanes (vaned, agitator)");
    vaned_.vanes = static_cast<int>(vanes);
    if (vaned_.tip_radius <= vaned_.hub_radius && !options_.help())
      refuse("tip_radius", to_text(vaned_.tip_radius),
             "above -" + name_ + "_hub_radius " + to_text(vaned_.hub_radius) + ", or the hub hides the vanes");
    if (vaned_.tip_radius < 0.5 * vaned_.vane_thickness)
      refuse("tip_radius", to_text(vaned_.tip_radius),
             "at least half of -" + name_ + "_vane_thickness " + to_text(vaned_.vane_thickness));
  }

  void read_agitator(OptionBlock& block) {
    AgitatorDimensions& a = agitator_;
    block.real("post_radius", a.post_radius, "m", positive,
               "radius of the post and of the half sphere on it (agitator)");
    block.real("post_height", a.post_height, "m", positive, "height of the half sphere's top (agitator)");
    block.real("dome_radius", a.dome_radius, "m", positive, "radius of the dome (agitator)");
    block.real("dome_height", a.dome_height, "m", positive, "height of the dome (agitator)");
    block.real("tip_radius", a.tip_radius, "m", positive, "reach of the vanes from the axis (agitator)");
    block.real("vane_height", a.vane_height, "m", positive, "height of the vanes' tops (agitator)");
    block.real("vane_thickness", a.vane_thickness, "m", positive, "thickness of a vane (agitator)");
    PetscInt vanes = a.vanes;
    block.integer("vanes", vanes, copies, "number of vanes (agitator)");
    a.vanes = static_cast<int>(vanes);
    std::vector<double> curve(a.curve, a.curve + 3);
    block.reals("vane_curve", curve, 3, 3, "-",
                "plan of a vane: c1,c2,c3 of y/R = c1 x/R + c2 (x/R)^2 + c3 (x/R)^3, R = tip_radius (agitator)");
    std::copy(curve.begin(), curve.end(), a.curve);
    if (options_.help()) return;
    if (a.tip_radius <= a.post_radius)
      refuse("tip_radius", to_text(a.tip_radius), "above the post's radius, or the post hides the vanes");
    if (a.post_height < a.post_radius) refuse("post_height", to_text(a.post_height), "at least the post's radius");
    if (a.vane_height < 0.5 * a.vane_thickness)
      refuse("vane_height", to_text(a.vane_height), "at least half of the vanes' thickness");
    if (a.tip_radius < a.vane_thickness) refuse("tip_radius", to_text(a.tip_radius), "at least the vanes' thickness");
  }

  void read_place(OptionBlock& block) {
    block.real("rounding", rounding_, "m", non_negative,
               "grows the shape by this, so that its edges are round; 0: it stays as it is");
    block.template point<Dim>("offset", offset_, "m", "place of the shape's origin in its parent's frame");
    block.real("turn", turn_, "degrees", any_number, "turn about z in its parent's frame, counter-clockwise");
    block.integer("repeat", repeat_, copies, "copies, spread evenly about z of the parent's frame");
    block.boolean("inverted", inverted_, "the solid is outside the shape (a drum)");
  }

  ShapePtr<Dim> primitive() const {
    if (kind_ == ShapeKind::sphere) return std::make_unique<Sphere<Dim>>(radius_);
    if (kind_ == ShapeKind::box) return std::make_unique<Cuboid<Dim>>(size_);
    if (kind_ == ShapeKind::halfspace) return std::make_unique<HalfSpace<Dim>>(normal_);
    if (kind_ == ShapeKind::capsule) return std::make_unique<Capsule<Dim>>(from_, to_, radius_);
    if constexpr (Dim == 2)
      return outline();
    else if (kind_ == ShapeKind::stl)
      return shape_from_stl(options_, stl_, name_);
    else if (kind_ == ShapeKind::agitator)
      return sampled_agitator(options_.comm(), agitator_, sample_spacing_, name_);
    else if (kind_ == ShapeKind::revolution)
      return std::make_unique<Revolved>(std::make_unique<Polygon>(corners_, Polygon::Kind::profile));
    else
      return std::make_unique<Extruded>(outline(), height_);
  }

  ShapePtr<2> outline() const {
    if (kind_ == ShapeKind::cylinder) return std::make_unique<Sphere<2>>(radius_);
    if (kind_ == ShapeKind::vaned) return vaned(vaned_);
    return std::make_unique<Polygon>(corners_);
  }

  ShapePtr<Dim> combination(ShapeList<Dim> parts) const {
    if (kind_ == ShapeKind::united) return std::make_unique<Union<Dim>>(std::move(parts));
    if (kind_ == ShapeKind::intersection) return std::make_unique<Intersection<Dim>>(std::move(parts));
    return difference<Dim>(std::move(parts));
  }

  // The identities are left out: a shape is evaluated at every face in every step.
  ShapePtr<Dim> in_place(ShapePtr<Dim> shape) const {
    if (rounding_ != 0) shape = named(std::make_unique<Rounded<Dim>>(std::move(shape), rounding_));
    if (turn_ != 0 || !offset_.isZero(0)) {
      const double angle = turn_ * std::numbers::pi / 180;
      shape = std::make_unique<Placed<Dim>>(std::move(shape), Pose<Dim>::at(offset_, angle));
    }
    if (repeat_ > 1) shape = std::make_unique<Repeated<Dim>>(std::move(shape), static_cast<int>(repeat_));
    if (inverted_) shape = named(std::make_unique<Inverted<Dim>>(std::move(shape)));
    return shape;
  }

  ShapePtr<Dim> named(ShapePtr<Dim> shape) const {
    shape->name = name_;
    return shape;
  }

  // All kinds; in the plane only those possible there.
  static std::vector<ShapeKind> kinds() {
    using enum ShapeKind;
    if (Dim == 3) return {};
    return {sphere, box, halfspace, capsule, polygon, vaned, united, intersection, difference};
  }

  // -help shows the options of every kind.
  bool used(const std::vector<ShapeKind>& kinds) const {
    return options_.help() || std::find(kinds.begin(), kinds.end(), kind_) != kinds.end();
  }

  static std::string text_of(const Points<2>& corners) {
    std::vector<std::string> texts;
    for (const auto& corner : corners) texts.push_back(list_text<2>(corner));
    return join(texts, ",");
  }

  [[noreturn]] void refuse(const std::string& option, const std::string& value, const std::string& allowed) const {
    throw InputError("-" + name_ + "_" + option + " " + value + ": must be " + allowed);
  }

  inline static const std::vector<ShapeKind> combinations{ShapeKind::united, ShapeKind::intersection,
                                                          ShapeKind::difference};

  Options& options_;
  std::string name_;
  ShapeKind kind_ = ShapeKind::sphere;
  double radius_ = 0.1, height_ = 0.2;
  Point<Dim> size_ = Point<Dim>::Constant(0.2), normal_ = Point<Dim>::Unit(Dim - 1);
  Point<Dim> from_ = Point<Dim>::Zero(), to_ = Point<Dim>::Zero();
  Points<2> corners_;
  VanedDimensions vaned_;
  AgitatorDimensions agitator_;
  double sample_spacing_ = 0;
  StlOptions stl_;
  std::vector<std::string> parts_;
  double rounding_ = 0, turn_ = 0;
  Point<Dim> offset_ = Point<Dim>::Zero();
  PetscInt repeat_ = 1;
  bool inverted_ = false;
};

}  // namespace

namespace {

// Ignores options of a shape and of parts that the body no longer has.
template <int Dim>
void leave_out_others(Options& options, const std::string& name, double sample_spacing, const std::string& fallback,
                      const std::vector<std::string>& parts) {
  const std::string option = name + "_shape";
  if (options.given().overridden(option, name + "_"))
    options.leave_out("-" + option + " is another now",
                      [&] { const ShapeReader<Dim> every(options, name, sample_spacing, fallback); });
  options.leave_out_dropped(name + "_parts", parts, [&](const std::string& part) {
    (void)shape_from_options<Dim>(options, name + "_" + part, sample_spacing);
  });
}

}  // namespace

template <int Dim>
ShapePtr<Dim> shape_from_options(Options& options, const std::string& name, double sample_spacing,
                                 const std::string& fallback) {
  const ShapeReader<Dim> reader(options, name, sample_spacing, fallback);
  for (const std::string& of : {name + "_", fallback})
    options.answer(of + "axis",
                   "bodies turn about z alone, through their -..._center; let the machine's axis lie along z, and "
                   "gravity along x or y where that is level (inputs/front_loader_filled.opts)");
  leave_out_others<Dim>(options, name, sample_spacing, fallback, reader.parts());
  if (options.help()) return nullptr;  // sizes may be missing, and no shape is needed
  for (const auto& part : reader.parts()) options.claim_prefix(name + "_" + part, "-" + name + "_parts");
  ShapeList<Dim> parts;
  for (const auto& part : reader.parts())
    parts.push_back(shape_from_options<Dim>(options, name + "_" + part, sample_spacing));
  return reader.build(std::move(parts));
}

template ShapePtr<2> shape_from_options<2>(Options&, const std::string&, double, const std::string&);
template ShapePtr<3> shape_from_options<3>(Options&, const std::string&, double, const std::string&);

}  // namespace washfsi
