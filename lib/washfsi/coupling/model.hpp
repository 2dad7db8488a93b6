// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/bodies/bodies.hpp"
#include "washfsi/contact/contact_force.hpp"
#include "washfsi/grid/options.hpp"

namespace washfsi {

/// The medium round the cloths.
enum class Medium { water, none };
const ChoiceNames<Medium>& names_of(Medium);

/// The carrier of the cloths' mass in excess of the water displaced: their markers; or, smeared, the water's density,
/// as in the thesis.
enum class MassCarrier { cloth, water };
const ChoiceNames<MassCarrier>& names_of(MassCarrier);

/// How cloths are treated, whatever they are made of.
struct ClothTreatment {
  MassCarrier mass_carrier = MassCarrier::water;
  double drag = 0;           ///< without fluid: force per undeformed area and speed [kg/(m2 s)]
  bool films_drain = false;  ///< whether films between cloths nearer than a cell drain
  WallTreatment wall_model =
      WallTreatment::none;     ///< law of the friction along cloth, whose layers cells do not resolve
  double verify_interval = 0;  ///< between counts of intersections [s]; 0: each step with a barrier, else never
};

/// All options of the model except for its initial state.
template <int Dim>
struct ModelOptions {
  GridOptions<Dim> grid;
  FluidOptions<Dim> fluid;
  Medium medium = Medium::water;
  ClothTreatment cloth;
  Point<Dim> gravity = Point<Dim>::Zero();  ///< acts on the cloths' excess mass: p is measured from hydrostatic [m/s2]
  std::vector<ClothGroup<Dim>> cloths;
  std::vector<MakeForce<Dim>> surrounding_forces;  ///< makers of the forces on the cloths from their surroundings
  bool cloth_limits_advection = false;             ///< whether central advection becomes upwind beside cloth
  BodyTreatment treatment;
  DeltaOptions delta;

  static ModelOptions from_options(Options& options, MassCarrier mass_carrier, const Refinement& refinement);
};

/// The model: water, bodies and cloths, and the operators between them. `fluid` stores the water's velocity and
/// pressure.
template <int Dim>
struct Model {
  /// Collective. Errors: InputError.
  Model(MPI_Comm comm, const ModelOptions<Dim>& options, std::vector<Body<Dim>> rigid_bodies);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// Creates the forces on cloths; `start` are the initial positions of this rank's markers. Collective. Errors:
  /// InputError.
  void add_forces(const ModelOptions<Dim>& options, const Points<Dim>& start);
  /// Fixes spread and interpolate at these places of the markers. Finds `cloth_nearness` there and, if the water
  /// carries the cloths' excess mass, the density. Collective. Errors: DivergedError if a marker has left the box.
  void locate_cloth(const Points<Dim>& places);
  /// Nearness of faces to edges and cloth beside which central advection becomes upwind (`StepFields`); null if there
  /// are none. Collective.
  Vec upwind_weight() const;
  /// The sequence of a water step together with the walls' forces.
  WaterStep<Dim> water_step() { return {fluid, bodies.wall_forces()}; }

  Grid<Dim> grid;
  std::vector<Body<Dim>> body_list;
  Boundary<Dim> boundary;
  Bodies<Dim> bodies;
  Liquid<Dim> liquid;
  FractionalStep<Dim> fluid;
  std::vector<std::unique_ptr<ForceField>> water_forces;  ///< on the water, beside those of walls and cloths
  Cloths<Dim> cloths;
  Forces<Dim> forces;
  Transfer<Dim> transfer;
  bool has_fluid;  ///< false: cloth alone
  ClothTreatment cloth_treatment;
  petsc::Vector
      cloth_nearness;  ///< weight of upwind advection beside cloth, on faces; null where cloth does not limit advection
};

extern template struct ModelOptions<2>;
extern template struct ModelOptions<3>;
extern template struct Model<2>;
extern template struct Model<3>;

}  // namespace washfsi
