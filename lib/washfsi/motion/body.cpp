// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/motion/body.hpp"

#include <algorithm>
#include <limits>

#include "washfsi/shapes/shape_options.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

template <int Dim>
Body<Dim> Body<Dim>::from_options(Options& options, const std::string& name, double sample_spacing) {
  Body<Dim> body;
  body.name = name;
  body.shape = shape_from_options<Dim>(options, name, sample_spacing, "bodies_");
  body.motion = RigidMotion<Dim>::from_options(options, name);
  return body;
}

const ChoiceNames<BodyMethod>& names_of(BodyMethod) {
  static const ChoiceNames<BodyMethod> names{{"mapping", BodyMethod::mapping},
                                             {"mapping_variable", BodyMethod::mapping_variable},
                                             {"ghost", BodyMethod::ghost},
                                             {"cut_stencil", BodyMethod::cut_stencil},
                                             {"direct_forcing", BodyMethod::direct_forcing}};
  return names;
}

const ChoiceNames<MaskEdge>& names_of(MaskEdge) {
  static const ChoiceNames<MaskEdge> names{{"sharp", MaskEdge::sharp}, {"smooth", MaskEdge::smooth}};
  return names;
}

BodyTreatment BodyTreatment::from_options(Options& options) {
  constexpr Range spacings{0.5, 2, false, "from 0.5 to 2"};
  BodyTreatment treatment;
  options.block("", "Bodies and water", [&](OptionBlock& block) {
    block.choice(
        "body_method", treatment.method,
        "how bodies hold the water: direct_forcing, the most accurate, by markers on the walls; mapping is the thesis's"
        " (4.2-6) with the plain projection (4.2-12), mapping_variable with (4.2-9); ghost extrapolates velocities"
        " through the wall; with cut_stencil viscous stencils end at the walls");
    block.choice("body_mask", treatment.edge,
                 "mask of the solid; smooth over two spacings to either side, for the mapping methods");
    block.real(
        "body_marker_spacing", treatment.marker_spacing, "cells", spacings,
        "least distance of the middles of patches, whose markers share one force: 1.2 times this on thin parts, 1.3 "
        "times round solids (direct_forcing)");
    block.real("body_slip_tolerance", treatment.slip_tolerance, "-", tight,
               "rms slip that is left at each body, as deltas see it, over the largest speed (direct_forcing)");
    block.boolean("body_limits_advection", treatment.limits_advection,
                  "beside edges and thin parts -advection central gives way to upwind (direct_forcing)");
  });
  const bool puts_wall = treatment.method != BodyMethod::mapping && treatment.method != BodyMethod::mapping_variable;
  if (treatment.edge == MaskEdge::smooth && puts_wall)
    throw InputError("-body_mask smooth: needs -body_method mapping or mapping_variable; " + name_of(treatment.method) +
                     " puts the wall where it is");
  if (treatment.method != BodyMethod::direct_forcing)
    options.mark_idle("-body_method is " + name_of(treatment.method),
                      {"body_marker_spacing", "body_slip_tolerance", "body_limits_advection"});
  return treatment;
}

template <int Dim>
std::vector<Body<Dim>> bodies_from_options(Options& options, double cell) {
  std::vector<std::string> names;
  options.block("", "Bodies", [&](OptionBlock& block) { block.names("bodies", names, "names of the rigid bodies"); });
  if (names.empty()) names = options.examples("drum", "BODY");
  const auto read = [&](const std::string& name) { return Body<Dim>::from_options(options, name, 0.5 * cell); };
  std::vector<Body<Dim>> bodies;
  for (const auto& name : names) options.claim_prefix(name, "-bodies");
  for (const auto& name : names) bodies.push_back(read(name));
  options.leave_out_dropped("bodies", names, read);
  return bodies;
}

namespace {

constexpr double fewest_steps = 10;  // steps in a period, a ramp, a stroke

}  // namespace

template <int Dim>
void refuse_unseen_motion(const std::vector<Body<Dim>>& bodies, double time_step) {
  for (const auto& body : bodies)
    if (const auto [option, duration] = body.motion.shortest_span(); time_step * fewest_steps > duration * (1 + 1e-12))
      throw InputError("-" + body.name + "_" + option + ": -time_step " + to_text(time_step) +
                       " is longer than a tenth of the " + to_text(duration) + " s that it takes");
}

template <int Dim>
double longest_step_of_motion(const std::vector<Body<Dim>>& bodies) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& body : bodies) shortest = std::min(shortest, body.motion.shortest_span().duration);
  return shortest / fewest_steps;
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
template void refuse_unseen_motion<2>(const std::vector<Body<2>>&, double);
template void refuse_unseen_motion<3>(const std::vector<Body<3>>&, double);
template double longest_step_of_motion<2>(const std::vector<Body<2>>&);
template double longest_step_of_motion<3>(const std::vector<Body<3>>&);
template double nearest_distance<2>(const std::vector<Body<2>>&, const Point<2>&, double);
template double nearest_distance<3>(const std::vector<Body<3>>&, const Point<3>&, double);

}  // namespace washfsi
