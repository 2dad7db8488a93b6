// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/idle_options.hpp"

#include <algorithm>

namespace washfsi {

namespace {

template <int Dim>
void mark_without_water(Options& options, const CaseOptions<Dim>& chosen) {
  const std::string reason = "-fluid is none";
  options.mark_idle(reason, {"fluid_density",
                             "fluid_viscosity",
                             "fluid_projection",
                             "fluid_pressure_gradient",
                             "fluid_bulk_velocity",
                             "advection",
                             "advection_steps",
                             "momentum_tolerance",
                             "pressure_tolerance",
                             "turbulence",
                             "turbulence_constant",
                             "wall_model",
                             "fluid_initial*",
                             "delta_*",
                             "body_method",
                             "body_mask",
                             "body_marker_spacing",
                             "body_balance",
                             "body_slip_tolerance",
                             "body_limits_advection",
                             "cloth_inertia",
                             "contact_drainage",
                             "statistics",
                             "statistics_*",
                             "cloth_limits_advection",
                             "cloth_wall_model",
                             "coupling_mobility*",
                             "coupling_order",
                             "coupling_sweeps",
                             "coupling_slip_tolerance",
                             "coupling_time_scheme",
                             "time_max_cfl"});
  for (const auto& group : chosen.model.cloths) options.mark_idle(reason, {group.name + "_permeance"});
}

void mark_without_cloths(Options& options) {
  const std::string reason = "-cloths names none";
  options.mark_idle(
      reason, {"coupling_*", "cloth_inertia", "cloth_limits_advection", "cloth_wall_model", "cloth_drag", "contact",
               "contact_*", "gravity", "rest_speed", "time_tolerance", "machine_orbit_center", "delta_*"});
}

// Marks options of couplings, each of which uses only some of them.
template <int Dim>
void mark_of_coupling(Options& options, const CaseOptions<Dim>& chosen) {
  const std::string& scheme = chosen.coupling.scheme;
  const std::string reason = "-coupling_scheme is " + scheme;
  const bool semi_implicit = scheme == "semi_implicit", implicit = scheme == "implicit";
  if (!semi_implicit) options.mark_idle(reason, {"coupling_order", "coupling_sweeps", "coupling_slip_tolerance"});
  if (!implicit) options.mark_idle(reason, {"coupling_time_scheme"});
  if (!semi_implicit && !implicit)
    options.mark_idle(reason, {"coupling_mobility", "coupling_mobility_factor", "coupling_tolerance"});
  for (const auto& group : chosen.model.cloths) {
    if (semi_implicit) options.mark_idle(reason, {group.name + "_damping"});
    if (chosen.model.cloth.mass_carrier == MassCarrier::water)
      options.mark_idle("-cloth_inertia is water", {group.name + "_velocity"});
  }
}

template <int Dim>
void mark_of_cloths(Options& options, const CaseOptions<Dim>& chosen) {
  const auto& groups = chosen.model.cloths;
  if (std::ranges::all_of(groups, [](const auto& group) { return group.excess_mass == 0; }))
    options.mark_idle("no cloth has an excess mass", {"gravity"});
  if (!chosen.model.fluid.advects_centrally())
    options.mark_idle("-advection is " + chosen.model.fluid.advection, {"cloth_limits_advection"});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string& name = groups[g].name;
    const ClothShape shape = groups[g].shape;
    const PlacementOptions<Dim>& placement = chosen.placements[g];
    if (chosen.model.cloth.wall_model == WallTreatment::none)
      options.mark_idle("-cloth_wall_model is none", {name + "_held_water"});
    const std::string reason = "-" + name + "_shape is " + name_of(shape);
    if (shape != ClothShape::ellipse) options.mark_idle(reason, {name + "_semi_axes"});
    if (shape != ClothShape::mode) options.mark_idle(reason, {name + "_mode"});
    if (shape != ClothShape::mode && shape != ClothShape::bar_mode) options.mark_idle(reason, {name + "_amplitude"});
    if (shape != ClothShape::crumpled) options.mark_idle(reason, {name + "_crumpling"});
    const bool shaken = placement.rule == PlacementRule::radial && (placement.shift > 0 || placement.tilt > 0);
    if (shape != ClothShape::crumpled && placement.rule != PlacementRule::random && !shaken)
      options.mark_idle("nothing of " + name + " is random", {name + "_seed"});
  }
}

template <int Dim>
bool has_walls(const GridOptions<Dim>& grid) {
  return std::ranges::any_of(grid.sides, [](const auto& ends) {
    return std::ranges::any_of(ends, [](const auto& side) { return side.kind == BoundaryKind::wall; });
  });
}

}  // namespace

template <int Dim>
void mark_idle_options(Options& options, const CaseOptions<Dim>& chosen, const std::vector<Body<Dim>>& bodies) {
  const ModelOptions<Dim>& model = chosen.model;
  const bool has_water = model.medium == Medium::water, has_cloths = !model.cloths.empty();
  const bool markers_on_bodies = !bodies.empty() && model.treatment.method == BodyMethod::direct_forcing;
  if (!has_cloths) mark_without_cloths(options);
  if (!has_water) mark_without_water<Dim>(options, chosen);
  if (has_water) options.mark_idle("-fluid is water", {"cloth_drag"});
  if (has_water && has_cloths) mark_of_coupling<Dim>(options, chosen);
  if (has_cloths) mark_of_cloths<Dim>(options, chosen);
  if (bodies.empty())
    options.mark_idle("-bodies names none", {"body_method", "body_mask", "body_marker_spacing", "body_slip_tolerance",
                                             "body_limits_advection", "body_balance"});
  if (!has_walls(model.grid) && !markers_on_bodies)
    options.mark_idle("the box has no walls, and no bodies are held by markers", {"wall_model"});
}

template void mark_idle_options<2>(Options&, const CaseOptions<2>&, const std::vector<Body<2>>&);
template void mark_idle_options<3>(Options&, const CaseOptions<3>&, const std::vector<Body<3>>&);

}  // namespace washfsi
