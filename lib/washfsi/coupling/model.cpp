// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/coupling/model.hpp"

#include <cmath>

#include "washfsi/cloth/damping.hpp"
#include "washfsi/cloth/dead_loads.hpp"
#include "washfsi/cloth/elasticity.hpp"
#include "washfsi/cloth/holding_springs.hpp"
#include "washfsi/cloth/inertia.hpp"
#include "washfsi/contact/contact_options.hpp"
#include "washfsi/immersed_boundary/edge_nearness.hpp"
#include "washfsi/mask/drum_walls.hpp"
#include "washfsi/motion/repeat_bodies.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

const ChoiceNames<Medium>& names_of(Medium) {
  static const ChoiceNames<Medium> names{{"water", Medium::water}, {"none", Medium::none}};
  return names;
}

const ChoiceNames<MassCarrier>& names_of(MassCarrier) {
  static const ChoiceNames<MassCarrier> names{{"cloth", MassCarrier::cloth}, {"water", MassCarrier::water}};
  return names;
}

namespace {

// Ghost layers that contain the stencil of a marker anywhere in an owned cell.
template <int Dim>
GridShape<Dim> with_ghosts_for(GridShape<Dim> shape, const ModelOptions<Dim>& options) {
  const DeltaOptions& delta = options.delta;
  shape.ghost_width = static_cast<PetscInt>(std::ceil(std::max(delta.spread_width, delta.interpolate_width))) + 1;
  // a probe lies at most two spacings from the face that it serves
  if (options.treatment.method == BodyMethod::ghost || options.treatment.method == BodyMethod::direct_forcing)
    shape.ghost_width = std::max<PetscInt>(shape.ghost_width, 3);
  return shape;
}

template <int Dim>
bool cloth_limits(const ModelOptions<Dim>& options) {
  return options.cloth_limits_advection && options.fluid.advects_centrally() && !options.cloths.empty();
}

template <int Dim>
FluidOptions<Dim> with_edges(const ModelOptions<Dim>& options, const Bodies<Dim>& bodies) {
  FluidOptions<Dim> fluid = options.fluid;
  fluid.limits_at_edges = cloth_limits(options) || bodies.upwind_weight();
  return fluid;
}

}  // namespace

template <int Dim>
ModelOptions<Dim> ModelOptions<Dim>::from_options(Options& options, MassCarrier mass_carrier,
                                                  const Refinement& refinement) {
  ModelOptions<Dim> model;
  model.cloth.mass_carrier = mass_carrier;
  model.grid = GridOptions<Dim>::from_options(options, refinement);
  model.fluid = FluidOptions<Dim>::from_options(options);
  options.block("", "Fluid or none", [&](OptionBlock& block) {
    block.choice("fluid", model.medium, "none: cloth alone, as in a vacuum or with a linear drag");
    block.real("cloth_drag", model.cloth.drag, "kg/(m2 s)", non_negative,
               "without fluid: force per undeformed area and speed; 0: none, as in a vacuum");
  });
  options.block("", "Gravity", [&](OptionBlock& block) {
    block.template point<Dim>("gravity", model.gravity, "m/s2", "acceleration by gravity, acting on excess mass");
  });
  model.cloths = cloth_groups_from_options<Dim>(options, refinement);
  options.block("", "Water beside cloth", [&](OptionBlock& block) {
    block.boolean("cloth_limits_advection", model.cloth_limits_advection,
                  "beside cloth -advection central gives way to upwind, for thin liquids and coarse grids");
    block.choice(
        "cloth_wall_model", model.cloth.wall_model,
        "friction along cloth: of the two cells of water that its kernels drag along, or by the law of the wall");
  });
  if (model.cloth.wall_model != WallTreatment::none && model.fluid.viscosity == 0)
    throw InputError("-cloth_wall_model " + name_of(model.cloth.wall_model) + ": needs a -fluid_viscosity > 0");
  model.treatment = BodyTreatment::from_options(options);
  if (model.medium == Medium::none) model.treatment.method = BodyMethod::mapping;  // there is no water to hold
  model.treatment.inner_water_slides = model.fluid.wall_model != WallTreatment::none;
  model.delta = DeltaOptions::from_options(options);
  const ContactOptions contact = ContactOptions::from_options(options, !model.cloths.empty(), refinement);
  model.surrounding_forces = contact.forces<Dim>(model.medium == Medium::water);
  model.cloth.films_drain = contact.drainage;
  model.cloth.verify_interval = contact.verify_interval;
  return model;
}

template <int Dim>
Model<Dim>::Model(MPI_Comm comm, const ModelOptions<Dim>& options, std::vector<Body<Dim>> rigid_bodies)
    : grid(comm, with_ghosts_for(options.grid.shape, options)),
      body_list(repeat_bodies<Dim>(grid, std::move(rigid_bodies))),
      boundary(grid, sides_with_drum<Dim>(options.grid.sides, options.grid.shape, body_list)),
      bodies(grid, boundary, body_list, options.treatment, options.fluid),
      liquid(grid, boundary, {options.fluid.density, options.fluid.viscosity}, options.fluid.viscosity_models,
             options.fluid.wall_model),
      fluid(grid, boundary, with_edges<Dim>(options, bodies)),
      cloths(comm, options.cloths),
      forces(cloths),
      transfer(grid, boundary, options.delta),
      has_fluid(options.medium == Medium::water),
      cloth_treatment(options.cloth) {
  if (cloth_limits(options)) cloth_nearness = grid.face_vector();
}

// Adds the forces in the order in which they are summed.
template <int Dim>
void Model<Dim>::add_forces(const ModelOptions<Dim>& options, const Points<Dim>& start) {
  forces.add(std::make_unique<Elasticity<Dim>>(cloths));
  if (uses(cloths.groups(), ElasticModel::love)) forces.add(std::make_unique<StrongElasticity<Dim>>(cloths));
  forces.add(std::make_unique<HoldingSprings<Dim>>(cloths, start));
  for (const MakeForce<Dim>& make : options.surrounding_forces)
    if (auto force = make({grid, boundary, body_list, cloths})) forces.add(std::move(force));
  if (has_fluid && cloth_treatment.mass_carrier == MassCarrier::cloth)
    forces.add(std::make_unique<Inertia<Dim>>(cloths));
  forces.add(std::make_unique<Damping<Dim>>(cloths));
  forces.add(std::make_unique<DeadLoads<Dim>>(cloths, options.gravity));
}

template <int Dim>
void Model<Dim>::locate_cloth(const Points<Dim>& places) {
  transfer.locate(places);
  if (cloth_nearness) find_edge_nearness<Dim>(grid, transfer, std::vector<bool>(places.size(), true), cloth_nearness);
  if (cloths.marker_count() == 0 || cloth_treatment.mass_carrier == MassCarrier::cloth) return;
  liquid.reset_density();
  transfer.spread_mass(cloths.marker_masses(), liquid.density());
}

template <int Dim>
Vec Model<Dim>::upwind_weight() const {
  const Vec of_walls = bodies.upwind_weight();
  if (!cloth_nearness || !of_walls) return cloth_nearness ? static_cast<Vec>(cloth_nearness) : of_walls;
  WASH_PETSC(VecPointwiseMax(cloth_nearness, cloth_nearness, of_walls));
  return cloth_nearness;
}

template struct ModelOptions<2>;
template struct ModelOptions<3>;
template struct Model<2>;
template struct Model<3>;

}  // namespace washfsi
