// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/body.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

Vaned::Dimensions read_vaned(OptionBlock& block, const std::string& name) {
  Vaned::Dimensions vaned;
  PetscInt vanes = vaned.vanes;
  block.real("hub_radius", vaned.hub_radius, "m", positive, "radius of the hub (vaned)");
  block.real("tip_radius", vaned.tip_radius, "m", positive, "reach of the vanes from the centre (vaned)");
  block.real("vane_thickness", vaned.vane_thickness, "m", positive, "thickness of a vane (vaned)");
  block.integer("vanes", vanes, at_least_one, "number of vanes (vaned)");
  vaned.vanes = static_cast<int>(vanes);
  if (vaned.tip_radius < 0.5 * vaned.vane_thickness)
    throw InputError("-" + name + "_tip_radius " + to_text(vaned.tip_radius) + ": must be at least half of -" + name +
                     "_vane_thickness " + to_text(vaned.vane_thickness));
  return vaned;
}

}  // namespace

template <int Dim>
Body<Dim> Body<Dim>::from_options(Options& options, const std::string& name) {
  Body<Dim> body;
  body.name = name;
  options.block(name + "_", "Body " + name, [&](OptionBlock& block) {
    std::string kind = "sphere";
    bool inverted = false;
    const std::vector<std::string> kinds =
        Dim == 2 ? std::vector<std::string>{"sphere", "vaned"} : std::vector<std::string>{"sphere"};
    block.choice("shape", kind, kinds, "shape of the body; sphere is a circle in the plane");
    block.template point<Dim>("center", body.motion.center, "m", "place of the body's centre, about which it turns");
    block.boolean("inverted", inverted, "the solid is outside the shape (a drum)");
    block.real("angular_speed", body.motion.angular_speed, "rad/s", any_number,
               "speed of rotation, or its largest value");
    block.real("frequency", body.motion.frequency, "Hz", non_negative, "of an oscillating rotation; 0: steady");
    if (kind == "sphere" || options.help()) {
      double radius = 0.1;
      block.real("radius", radius, "m", positive, "radius (sphere)");
      body.shape = std::make_unique<Sphere<Dim>>(radius);
    }
    if constexpr (Dim == 2) {
      if (kind == "vaned" || options.help()) body.shape = std::make_unique<Vaned>(read_vaned(block, name));
    }
    if (inverted) body.shape = std::make_unique<Inverted<Dim>>(std::move(body.shape));
  });
  return body;
}

BodyTreatment BodyTreatment::from_options(Options& options) {
  static const std::map<std::string, BodyMethod> methods{{"mapping", BodyMethod::mapping},
                                                         {"mapping_variable", BodyMethod::mapping_variable},
                                                         {"ghost", BodyMethod::ghost},
                                                         {"cut_stencil", BodyMethod::cut_stencil}};
  std::string method = "mapping", mask = "sharp";
  options.block("", "Bodies and water", [&](OptionBlock& block) {
    block.choice("body_method", method, {"mapping", "mapping_variable", "ghost", "cut_stencil"},
                 "how bodies hold the water: mapping is the thesis's (4.2-6) with the plain projection (4.2-12),"
                 " mapping_variable with (4.2-9); ghost extrapolates velocities through the wall; with cut_stencil, the"
                 " most accurate, viscous stencils end at the walls");
    block.choice("body_mask", mask, {"sharp", "smooth"},
                 "mask of the solid; smooth over two spacings to either side, for the mapping methods");
  });
  const BodyTreatment treatment{methods.at(method), mask == "smooth"};
  if (treatment.smooth && (treatment.method == BodyMethod::ghost || treatment.method == BodyMethod::cut_stencil))
    throw InputError("-body_mask smooth: needs -body_method mapping or mapping_variable; " + method +
                     " puts the wall where it is");
  return treatment;
}

template <int Dim>
std::vector<Body<Dim>> bodies_from_options(Options& options) {
  std::vector<std::string> names;
  options.block("", "Bodies", [&](OptionBlock& block) { block.names("bodies", names, "names of the rigid bodies"); });
  if (options.help() && names.empty()) names = {"drum"};  // so that -help shows a body's options
  std::vector<Body<Dim>> bodies;
  for (const auto& name : names) options.claim_prefix(name, "-bodies");
  for (const auto& name : names) bodies.push_back(Body<Dim>::from_options(options, name));
  return bodies;
}

template <int Dim>
double nearest_distance(const std::vector<Body<Dim>>& bodies, const Point<Dim>& place, double time) {
  double nearest = std::numeric_limits<double>::max();
  for (const auto& body : bodies) nearest = std::min(nearest, body.distance(place, time));
  return nearest;
}

template struct Body<2>;
template struct Body<3>;
template std::vector<Body<2>> bodies_from_options<2>(Options&);
template std::vector<Body<3>> bodies_from_options<3>(Options&);
template double nearest_distance<2>(const std::vector<Body<2>>&, const Point<2>&, double);
template double nearest_distance<3>(const std::vector<Body<3>>&, const Point<3>&, double);

}  // namespace washfsi
