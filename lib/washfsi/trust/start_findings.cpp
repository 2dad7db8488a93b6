// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/start_findings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "washfsi/measure/crossings.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/format_text.hpp"
#include "washfsi/trust/body_findings.hpp"
#include "washfsi/trust/contact_findings.hpp"
#include "washfsi/trust/resting_sides.hpp"

namespace washfsi {

namespace {

constexpr double water_viscosity = 1e-3;                       // [Pa s], at 20 degrees C
constexpr double lightest_water = 900, heaviest_water = 1100;  // [kg/m3]

template <int Dim>
bool is_water(const Model<Dim>& model) {
  const double density = model.liquid.pure().density;
  return model.has_fluid && density > lightest_water && density < heaviest_water;
}

// ---- the flow ----

template <int Dim>
void add_water(const Model<Dim>& model, Findings& findings) {
  if (!is_water(model)) return;
  const double times = model.liquid.pure().viscosity / water_viscosity;
  findings.push_back(at_most("viscosity", times, {2},
                             format_text("%.4g Pa s, %.4g times water's", model.liquid.pure().viscosity, times),
                             "flow, torque and stress are those of a thick liquid; water is -fluid_viscosity 1e-3"));
}

// A law models the layers at the box's sides; for bodies in direct forcing it has been validated little.
template <int Dim>
void add_wall_model(const Model<Dim>& model, Findings& findings) {
  const bool on_bodies = model.bodies.wall_law() && model.bodies.wall_law()->point_count() > 0;
  findings.push_back(
      {"wall model",
       on_bodies
           ? format_text("of the box's sides, and at %zu points of bodies", model.bodies.wall_law()->point_count())
           : "of the box's sides, not of bodies",
       Verdict::warn, Finding::none, Finding::none,
       on_bodies
           ? "the law of bodies is validated on flat walls and thin plates only, along the grid and at 20 degrees to "
             "it; compare with more -grid_cells"
           : "friction of bodies is that of the grid; -body_method direct_forcing, or more -grid_cells"});
}

// Central differences may let water go round the edges of a sheet as if it had no friction.
template <int Dim>
void add_water_beside_cloth(const Model<Dim>& model, double cell_reynolds, Findings& findings) {
  if (model.cloths.marker_count() == 0 || model.cloth_nearness || model.fluid.advection().scheme().is_bounded()) return;
  findings.push_back(at_most("water beside cloth", cell_reynolds, {100},
                             format_text("cell Reynolds number %.3g, central differences", cell_reynolds),
                             "what a stream loads cloth across it with depends on where it lies in its cells; "
                             "-cloth_limits_advection"));
}

template <int Dim>
void add_flow(const Model<Dim>& model, const FlowScales& scales, Findings& findings) {
  if (!model.has_fluid || scales.speed == 0) return;
  const double nu = model.liquid.pure().viscosity / model.liquid.pure().density;
  const double h = model.grid.spacing().maxCoeff(), root = std::sqrt(scales.reynolds);
  findings.push_back({"Reynolds number",
                      format_text("%.3g, of %.3g m/s and %.3g m, %s", scales.reynolds, scales.speed, scales.length,
                                  scales.length_of.c_str()),
                      Verdict::ok, scales.reynolds, Finding::none, "", Display::always});
  const double cell = scales.speed * h / nu, layer = 5 * scales.length / (root * h);
  if (!model.liquid.has_models())
    findings.push_back(
        at_most("cell Reynolds number", cell, {100}, format_text("%.3g, of the widest side of a cell", cell),
                "eddies smaller than a cell have no model; more -grid_cells, in space -turbulence sigma, or "
                "-advection upwind"));
  add_water_beside_cloth(model, cell, findings);
  if (model.liquid.walls()) {
    if (model.body_list.empty()) return;
    add_wall_model(model, findings);
    if (model.bodies.wall_law()) return;
  }
  findings.push_back(at_least("boundary layer", layer, {4}, format_text("%.2g cells", layer),
                              "friction and shear at walls are not resolved; more -grid_cells"));
  // Blasius' laminar plate; beyond 5e5 Prandtl's turbulent one
  const double friction = scales.reynolds < 5e5 ? 0.664 / root : 0.058 / std::pow(scales.reynolds, 0.2);
  const double plus = 0.5 * h * scales.speed * std::sqrt(0.5 * friction) / nu;
  findings.push_back(at_most("y+ of the first cell", plus, {5}, format_text("%.2g, as of a flat plate", plus),
                             model.liquid.walls()
                                 ? "the viscous layer on bodies lies within one cell; more -grid_cells"
                                 : "the viscous layer at walls lies within one cell; more -grid_cells, "
                                   "or -wall_model equilibrium"));
}

// ---- cloths ----

// The widest and narrowest spacing of its markers, over the mean spacing of the grid.
template <int Dim>
std::pair<double, double> spacings_in_cells(const ClothGroup<Dim>& group, const Grid<Dim>& grid) {
  const double h = std::pow(grid.cell_volume(), 1.0 / Dim);
  const double ds = group.sheet.ds / h, dr = Dim == 3 ? group.sheet.dr / h : ds;
  return {std::max(ds, dr), std::min(ds, dr)};
}

template <int Dim>
void add_cloth(const ClothGroup<Dim>& group, const Model<Dim>& model, Findings& findings) {
  const auto [widest, narrowest] = spacings_in_cells<Dim>(group, model.grid);
  const std::string name = group.name + " marker spacing";
  if (narrowest < 0.75)
    findings.push_back(
        at_least(name, narrowest, {0.75, 0.2}, format_text("%.3g cells", narrowest),
                 "markers this near lock the cloth: it is too stiff; fewer -" + group.name + "_markers"));
  else
    findings.push_back(at_most(name, widest, {1.5, 3}, format_text("%.3g cells", widest),
                               "water passes between its markers; more -" + group.name + "_markers"));
}

void add_distance(const System<3>& system, Findings& findings) {
  const Model<3>& model = system.model;
  if (model.cloths.pieces().size() < 2) return;
  ClothCrossings crossings(model.cloths);
  crossings.observe(system.state.positions);
  const double distance = crossings.least_distance(), h = std::cbrt(model.grid.cell_volume());
  if (distance < 0.1 * h)
    findings.push_back(at_least("distance of cloths", distance / h, {0.1, 1e-3},
                                format_text("%.3g m, %.2g cells", distance, distance / h),
                                "cloths that lie in each other move as one, or cross; place them apart"));
}

// ---- the box and the times ----

template <int Dim>
void add_box(const Model<Dim>& model, Findings& findings) {
  if (!is_water(model)) return;
  const double size = (model.grid.upper() - model.grid.lower()).maxCoeff();
  constexpr double smallest = 0.01, largest_size = 20;  // [m]
  const std::string text = format_text("%.3g m long", size), advice = "lengths are in metres";
  findings.push_back(size > largest_size ? at_most("box", size, {largest_size}, text, advice)
                                         : at_least("box", size, {smallest}, text, advice));
}

void add_times(const RunTimes& times, const Cycles& cycles, bool moves, Findings& findings) {
  const auto beyond = [&](const char* name, double interval, const char* what) {
    if (interval > times.end)
      findings.push_back(at_most(name, interval, {times.end}, format_text("%.3g s", interval), what));
  };
  beyond("checkpoint interval", times.checkpoint_interval, "nothing is kept before the end of the run");
  beyond("output interval", times.output_interval, "the series have only the first and the last frame");
  beyond("history interval", times.history_interval, "the history has only the last row, and means are of that alone");
  beyond("intersections interval", times.verify_interval, "they are counted at the start alone");
  beyond("start of statistics", times.sampling_start, "nothing is sampled; earlier -statistics_start");
  beyond("statistics interval", times.sampling_start + times.sampling_interval,
         "no sample is taken; shorter -statistics_interval");
  beyond("phases", times.sampling_start + times.phase_period,
         "the run ends before each phase has come; longer -time_end");
  if (!cycles.are_there()) {
    if (moves)
      findings.push_back({"cycles", "none, since no body moves periodically; -cycle_time would make them", Verdict::ok,
                          Finding::none, Finding::none, ""});
    return;
  }
  if (times.history_interval > 0.02 * cycles.period())
    findings.push_back(at_most("history interval", times.history_interval / cycles.period(), {0.02},
                               format_text("%.2g of a cycle", times.history_interval / cycles.period()),
                               "figures of cycles are made of too few rows"));
  const double complete = std::floor(times.end / cycles.period() + 1e-6);
  findings.push_back(at_least("cycles", complete, {Cycles::wanted},
                              format_text("%.0f of %.4g s", complete, cycles.period()),
                              "the first is start-up, and one more has no spread; longer -time_end"));
}

// The length of what water flows round or in, where no body drives it.
template <int Dim>
void choose_length(const Model<Dim>& model, const std::vector<BodySurvey<Dim>>& surveys, FlowScales& scales) {
  const Point<Dim> box = model.grid.upper() - model.grid.lower();
  scales.length = box.minCoeff();
  scales.length_of = "the narrowest side of the box";
  for (const auto& group : model.cloths.groups()) {
    scales.length = group.size[0];
    scales.length_of = "the length of " + group.name;
  }
  for (std::size_t b = 0; b < surveys.size(); ++b) {
    const Point<Dim> size = surveys[b].upper - surveys[b].lower;
    if (surveys[b].cells == 0 || (box - size).minCoeff() < 0.5 * model.grid.spacing().minCoeff()) continue;  // a drum
    scales.length = size.maxCoeff();
    scales.length_of = "the size of " + model.body_list[b].name;
  }
}

}  // namespace

template <int Dim>
FlowScales flow_scales(const Model<Dim>& model, const std::vector<BodySurvey<Dim>>& surveys) {
  FlowScales scales;
  WASH_PETSC(VecNorm(model.fluid.velocity(), NORM_INFINITY, &scales.speed));
  scales.speed = std::max(scales.speed, model.boundary.largest_speed(0));
  choose_length(model, surveys, scales);
  for (std::size_t b = 0; b < surveys.size(); ++b) {
    if (surveys[b].top_speed == 0 || surveys[b].top_speed < scales.speed) continue;
    scales.speed = surveys[b].top_speed;
    const RigidMotion<Dim>& motion = model.body_list[b].motion;
    const bool turns = motion.largest_speed(1) > motion.largest_speed(0);
    scales.length = turns ? surveys[b].reach : (surveys[b].upper - surveys[b].lower).maxCoeff();
    scales.length_of = (turns ? "the reach of " : "the size of ") + model.body_list[b].name;
  }
  scales.reynolds = scales.speed * scales.length * model.liquid.pure().density / model.liquid.pure().viscosity;
  return scales;
}

template <int Dim>
Findings start_findings(const System<Dim>& system, const Cycles& cycles, const RunTimes& times) {
  const Model<Dim>& model = system.model;
  const double time = system.state.clock.time;
  const auto surveys = survey_bodies<Dim>(model.grid, model.body_list, time);
  Findings findings;
  add_water(model, findings);
  add_flow(model, flow_scales(model, surveys), findings);
  add_box(model, findings);
  std::ranges::move(body_findings(model, surveys, time), std::back_inserter(findings));
  if (model.has_fluid) std::ranges::move(resting_side_findings(model, time), std::back_inserter(findings));
  if (model.has_fluid)
    for (const auto& group : model.cloths.groups()) add_cloth<Dim>(group, model, findings);
  if constexpr (Dim == 3)
    if (model.has_fluid) add_distance(system, findings);
  std::ranges::move(contact_findings(system), std::back_inserter(findings));
  add_times(times, cycles,
            std::ranges::any_of(model.body_list, [](const auto& body) { return !body.motion.at_rest(); }), findings);
  return findings;
}

template FlowScales flow_scales<2>(const Model<2>&, const std::vector<BodySurvey<2>>&);
template FlowScales flow_scales<3>(const Model<3>&, const std::vector<BodySurvey<3>>&);
template Findings start_findings<2>(const System<2>&, const Cycles&, const RunTimes&);
template Findings start_findings<3>(const System<3>&, const Cycles&, const RunTimes&);

}  // namespace washfsi
