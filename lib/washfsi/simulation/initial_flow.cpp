// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/initial_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "washfsi/simulation/channel_start.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

template <int Dim>
VelocityAt<Dim> rest(const Model<Dim>&, const InitialFlowOptions<Dim>&) {
  return [](const Point<Dim>&, int) { return 0; };
}

template <int Dim>
VelocityAt<Dim> uniform(const Model<Dim>&, const InitialFlowOptions<Dim>& options) {
  return [velocity = options.velocity](const Point<Dim>&, int c) { return velocity[c]; };
}

template <int Dim>
VelocityAt<Dim> taylor_green(const Model<Dim>& model, const InitialFlowOptions<Dim>&) {
  const Point<Dim> lower = model.grid.lower();
  const Point<Dim> wave = 2 * std::numbers::pi * (model.grid.upper() - lower).cwiseInverse();
  return [lower, wave](const Point<Dim>& place, int c) {
    const Point<Dim> angle = wave.cwiseProduct(place - lower);
    if (c == 0) return -std::cos(angle[0]) * std::sin(angle[1]);
    if (c == 1) return wave[0] / wave[1] * std::sin(angle[0]) * std::cos(angle[1]);
    return 0.0;
  };
}

template <int Dim>
VelocityAt<Dim> taylor_green_3d(const Model<Dim>& model, const InitialFlowOptions<Dim>& options) {
  const double speed = options.velocity[0] != 0 ? options.velocity[0] : 1;
  const Point<Dim> lower = model.grid.lower();
  const Point<Dim> wave = 2 * std::numbers::pi * (model.grid.upper() - lower).cwiseInverse();
  return [speed, lower, wave](const Point<Dim>& place, int c) {
    const Point<Dim> angle = wave.cwiseProduct(place - lower);
    const double along = Dim == 3 ? std::cos(angle[Dim - 1]) : 1;
    if (c == 0) return speed * std::sin(angle[0]) * std::cos(angle[1]) * along;
    if (c == 1) return -speed * wave[0] / wave[1] * std::cos(angle[0]) * std::sin(angle[1]) * along;
    return 0.0;
  };
}

// The radius of a circle or cylinder: the distance of its centre from its surface.
template <int Dim>
double radius_of(const Body<Dim>& body) {
  const Point<Dim> center = body.motion.center;
  const double radius = std::abs(body.distance(center, 0));
  if (std::abs(body.distance(center + radius * Point<Dim>::Unit(0), 0)) > 1e-9 * radius)
    throw InputError("-fluid_initial couette: body " + body.name + " is no circle, or a cylinder shorter than wide");
  return radius;
}

template <int Dim>
VelocityAt<Dim> couette(const Model<Dim>& model, const InitialFlowOptions<Dim>&) {
  const auto& bodies = model.body_list;
  if (bodies.size() != 2 || bodies[0].motion.center != bodies[1].motion.center || !bodies[0].motion.turns_steadily() ||
      !bodies[1].motion.turns_steadily())
    throw InputError(
        "-fluid_initial couette: needs two -bodies with one centre, a drum and a cylinder, that turn steadily");
  const Point<Dim> center = bodies[0].motion.center;
  const bool drum_first = bodies[0].distance(center, 0) > 0;
  const auto &drum = bodies[drum_first ? 0 : 1], &cylinder = bodies[drum_first ? 1 : 0];
  const double ro = radius_of(drum), ri = radius_of(cylinder);
  if (cylinder.distance(center, 0) >= 0 || ro <= ri)
    throw InputError("-fluid_initial couette: needs a drum (-..._inverted) and in it a cylinder with the same centre");
  const double wo = drum.motion.angular_speed, wi = cylinder.motion.angular_speed;
  const double a = (wo * ro * ro - wi * ri * ri) / (ro * ro - ri * ri);
  const double b = (wi - wo) * ri * ri * ro * ro / (ro * ro - ri * ri);
  return [=](const Point<Dim>& place, int c) {
    const Point<Dim> arm = place - center;
    const double r = arm.template head<2>().norm();
    const double turning = r < ri ? wi : r > ro ? wo : a + b / (r * r);
    return c == 0 ? turning * -arm[1] : c == 1 ? turning * arm[0] : 0.0;
  };
}

// The body that the user names, or the one that turns round its water: a drum does not contain its own centre.
template <int Dim>
const Body<Dim>& body_to_turn_with(const std::vector<Body<Dim>>& bodies, const std::string& name) {
  std::vector<const Body<Dim>*> found;
  std::vector<std::string> names;
  for (const auto& body : bodies) {
    names.push_back(body.name);
    const bool is_drum = body.distance(body.motion.center_at(0), 0) > 0 && body.motion.angular_velocity(0) != 0;
    if (name.empty() ? is_drum : body.name == name) found.push_back(&body);
  }
  if (!name.empty() && found.empty())
    throw InputError("-fluid_initial_body " + name + ": must be one of the -bodies" +
                     (names.empty() ? ", of which there are none" : " " + join(names, ",")));
  if (found.size() != 1)
    throw InputError(
        "-fluid_initial rotation: needs one drum (-..._inverted) that turns at the start, or "
        "-fluid_initial_body");
  if (found[0]->motion.angular_velocity(0) == 0)
    throw InputError("-fluid_initial_body " + name + ": this body does not turn at the start");
  return *found[0];
}

template <int Dim>
VelocityAt<Dim> rotation(const Model<Dim>& model, const InitialFlowOptions<Dim>& options) {
  const RigidMotion<Dim>& motion = body_to_turn_with<Dim>(model.body_list, options.body).motion;
  return [center = motion.center_at(0), omega = motion.angular_velocity(0)](const Point<Dim>& place, int c) {
    return c == 0 ? -omega * (place[1] - center[1]) : c == 1 ? omega * (place[0] - center[0]) : 0.0;
  };
}

template <int Dim>
VelocityAt<Dim> channel(const Model<Dim>& model, const InitialFlowOptions<Dim>& options) {
  return channel_start<Dim>(model.grid, options.velocity, options.channel);
}

template <int Dim>
struct NamedFlow {
  const char* name;
  VelocityAt<Dim> (*velocity)(const Model<Dim>&, const InitialFlowOptions<Dim>&);
};

// All flows.
template <int Dim>
const std::vector<NamedFlow<Dim>>& initial_flows() {
  static const std::vector<NamedFlow<Dim>> flows{
      {"rest", rest},        {"taylor_green", taylor_green}, {"taylor_green_3d", taylor_green_3d},
      {"channel", channel},  {"couette", couette},           {"uniform", uniform},
      {"rotation", rotation}};
  return flows;
}

}  // namespace

template <int Dim>
InitialFlowOptions<Dim> InitialFlowOptions<Dim>::from_options(Options& options) {
  InitialFlowOptions<Dim> initial;
  std::vector<std::string> names;
  for (const auto& flow : initial_flows<Dim>()) names.emplace_back(flow.name);
  options.block("", "Flow at the start", [&](OptionBlock& block) {
    block.choice("fluid_initial", initial.kind, names,
                 "velocity at the start; couette: steady flow between a turning drum and a turning cylinder in it;"
                 " rotation: turning with a drum; channel: between walls, with random vortices");
    block.template point<Dim>("fluid_initial_velocity", initial.velocity, "m/s",
                              "velocity of -fluid_initial uniform; mean velocity of channel; its x amplitude of "
                              "taylor_green_3d, where 0 stands for 1 m/s");
    block.text("fluid_initial_body", initial.body,
               "body with which the water turns, of -fluid_initial rotation; unless given the drum that turns");
  });
  initial.channel = ChannelStartOptions::from_options(options);
  const std::string kind = "-fluid_initial is " + initial.kind;
  const auto unless = [&](const std::vector<std::string>& kinds, const std::vector<std::string>& idle) {
    if (std::ranges::find(kinds, initial.kind) == kinds.end()) options.mark_idle(kind, idle);
  };
  unless({"uniform", "channel", "taylor_green_3d"}, {"fluid_initial_velocity"});
  unless({"rotation"}, {"fluid_initial_body"});
  unless({"channel"}, {"fluid_initial_profile", "fluid_initial_disturbance", "fluid_initial_seed"});
  return initial;
}

template <int Dim>
void start_flow(const InitialFlowOptions<Dim>& options, Model<Dim>& model) {
  for (const auto& flow : initial_flows<Dim>())
    if (options.kind == flow.name) model.fluid.start(flow.velocity(model, options));
}

template struct InitialFlowOptions<2>;
template struct InitialFlowOptions<3>;
template void start_flow<2>(const InitialFlowOptions<2>&, Model<2>&);
template void start_flow<3>(const InitialFlowOptions<3>&, Model<3>&);

}  // namespace washfsi
