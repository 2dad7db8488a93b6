// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/bodies/bodies.hpp"
#include "washfsi/contact/contact_force.hpp"
#include "washfsi/grid/options.hpp"

namespace washfsi {

/// What the cloths are in.
enum class Medium { water, none };
const ChoiceNames<Medium>& names_of(Medium);

/// What carries the cloths' mass over that of the water displaced: their markers; or, smeared, the water's density, as
/// in the thesis.
enum class MassCarrier { cloth, water };
const ChoiceNames<MassCarrier>& names_of(MassCarrier);

/// All options that describe what is simulated, but for how it starts.
template <int Dim>
struct ModelOptions {
  GridOptions<Dim> grid;
  FluidOptions<Dim> fluid;
  Medium medium = Medium::water;
  double cloth_drag = 0;  ///< without fluid: force per undeformed area and speed [kg/(m2 s)]
  MassCarrier mass_carrier = MassCarrier::water;
  Point<Dim> gravity = Point<Dim>::Zero();  ///< acts on the cloths' excess mass: p is measured from hydrostatic [m/s2]
  std::vector<ClothGroup<Dim>> cloths;
  std::vector<MakeForce<Dim>> surrounding_forces;  ///< on the cloths, from what is round them
  bool films_drain = false;                        ///< between cloths that are nearer than a cell
  bool cloth_limits_advection = false;             ///< beside cloth central advection gives way to upwind
  double verify_interval = 0;  ///< between counts of the cloths' intersections [s]; 0: after each step
  BodyTreatment treatment;
  DeltaOptions delta;

  static ModelOptions from_options(Options& options, MassCarrier mass_carrier);
};

/// What is simulated: water, bodies and cloths, and the operators between them. The water's velocity and pressure are
/// kept by `fluid`.
template <int Dim>
struct Model {
  /// Collective. Errors: InputError.
  Model(MPI_Comm comm, const ModelOptions<Dim>& options, std::vector<Body<Dim>> rigid_bodies);
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  /// Makes the forces on cloths whose markers of this rank start here.
  void add_forces(const ModelOptions<Dim>& options, const Points<Dim>& start);
  /// Fixes spread and interpolate, and the density of water and cloth, at these places of the markers. Collective.
  /// Errors: DivergedError if a marker has left the box.
  void locate_cloth(const Points<Dim>& places);
  /// How near faces are to what central advection gives way to upwind beside (`StepFields`); null if it does nowhere.
  /// Collective.
  Vec nearness() const;
  /// The water's step between the walls.
  WaterStep<Dim> water() { return {fluid, bodies.wall_forces()}; }

  Grid<Dim> grid;
  std::vector<Body<Dim>> body_list;
  Boundary<Dim> boundary;
  Bodies<Dim> bodies;
  Liquid<Dim> liquid;
  FractionalStep<Dim> fluid;
  Cloths<Dim> cloths;
  Forces<Dim> forces;
  Transfer<Dim> transfer;
  bool has_fluid;  ///< false: cloth alone
  MassCarrier mass_carrier;
  double cloth_drag;             ///< on cloth alone, force per undeformed area and speed [kg/(m2 s)]
  bool films_drain;              ///< between cloths that are nearer than a cell
  double verify_interval;        ///< between counts of the cloths' intersections [s]; 0: after each step
  petsc::Vector cloth_nearness;  ///< of faces; null where cloth does not limit advection
};

extern template struct ModelOptions<2>;
extern template struct ModelOptions<3>;
extern template struct Model<2>;
extern template struct Model<3>;

}  // namespace washfsi
