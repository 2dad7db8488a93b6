// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/body/body.hpp"

#include <algorithm>
#include <limits>

#include "washfsi/body/shape_options.hpp"

namespace washfsi {

template <int Dim>
Body<Dim> Body<Dim>::from_options(Options& options, const std::string& name, double sample_spacing) {
  Body<Dim> body;
  body.name = name;
  body.shape = shape_from_options<Dim>(options, name, sample_spacing);
  body.motion = RigidMotion<Dim>::from_options(options, name);
  return body;
}

BodyMethod body_method_from_options(Options& options) {
  std::string method = "mapping", mask = "sharp";
  options.block("", "Bodies and water", [&](OptionBlock& block) {
    block.choice("body_method", method, {"mapping", "cut_stencil"},
                 "how bodies hold the water: mapping is the thesis's (4.2-6) with (4.2-12); cut_stencil, more accurate,"
                 " also lets viscous stencils end at the walls");
    block.choice("body_mask", mask, {"sharp"}, "mask of the solid");
  });
  return method == "mapping" ? BodyMethod::mapping : BodyMethod::cut_stencil;
}

template <int Dim>
std::vector<Body<Dim>> bodies_from_options(Options& options, double cell) {
  std::vector<std::string> names;
  options.block("", "Bodies", [&](OptionBlock& block) { block.names("bodies", names, "names of the rigid bodies"); });
  if (options.help() && names.empty()) names = {"drum"};  // so that -help shows a body's options
  std::vector<Body<Dim>> bodies;
  for (const auto& name : names) options.claim_prefix(name, "-bodies");
  for (const auto& name : names) bodies.push_back(Body<Dim>::from_options(options, name, 0.5 * cell));
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
template std::vector<Body<2>> bodies_from_options<2>(Options&, double);
template std::vector<Body<3>> bodies_from_options<3>(Options&, double);
template double nearest_distance<2>(const std::vector<Body<2>>&, const Point<2>&, double);
template double nearest_distance<3>(const std::vector<Body<3>>&, const Point<3>&, double);

}  // namespace washfsi
