// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/mask.hpp"
#include "washfsi/cloth/cloths.hpp"
#include "washfsi/coupling/transfer.hpp"
#include "washfsi/fluid/fractional_step.hpp"
#include "washfsi/grid/options.hpp"
#include "washfsi/machine/placement.hpp"
#include "washfsi/simulation/contact.hpp"

namespace washfsi {

/// The machine's axis, a vertical, and the place of its (r, z) plane round which cloths tumble.
struct MachineAxis {
  Point<2> axis = Point<2>::Zero();          ///< x and y [m]
  Point<2> orbit_center = Point<2>::Zero();  ///< r and z [m]

  static MachineAxis from_options(Options& options, const GridShape<3>& shape);
};

/// All options that describe what is simulated.
template <int Dim>
struct SystemOptions {
  GridOptions<Dim> grid;
  FluidOptions<Dim> fluid;
  bool has_fluid = true;
  double cloth_drag = 0;                    ///< without fluid: force per undeformed area and speed [kg/(m2 s)]
  Point<Dim> gravity = Point<Dim>::Zero();  ///< acts on the cloths' excess mass: p is measured from hydrostatic [m/s2]
  std::vector<ClothGroup<Dim>> cloths;
  std::vector<PlacementOptions<Dim>> placements;
  BodyTreatment treatment;
  bool balance_loads = false;  ///< whether loads are measured by the balance of momentum too
  DeltaOptions delta;
  ContactOptions contact;
  MachineAxis machine;  ///< in space

  static SystemOptions from_options(Options& options);
};

/// Water, bodies and cloth together: everything that has a state, and the operators between them.
template <int Dim>
struct System {
  /// Sets up and places everything at t = 0. Collective. Errors: InputError.
  System(MPI_Comm comm, const SystemOptions<Dim>& options, std::vector<Body<Dim>> rigid_bodies);
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// Fixes spread and interpolate, and the density of water and cloth, at these places of the markers. Collective.
  /// Errors: DivergedError if a marker has left the box.
  void locate_cloth(const Points<Dim>& places);

  Grid<Dim> grid;
  Boundary<Dim> boundary;
  std::vector<Body<Dim>> bodies;
  Mask<Dim> mask;
  FractionalStep<Dim> fluid;
  Cloths<Dim> cloths;
  Transfer<Dim> transfer;

  double fluid_density;  ///< [kg/m3]
  bool has_fluid;        ///< false: cloth alone
  double cloth_drag;     ///< on cloth alone, force per undeformed area and speed [kg/(m2 s)]
  bool balance_loads;    ///< whether loads are measured by the balance of momentum too
  ContactOptions contact;
  MachineAxis machine;                            ///< in space
  Point<Dim> gravity;                             ///< [m/s2]
  petsc::Vector density;                          ///< of the last step, on faces [kg/m3]
  petsc::Vector force;                            ///< of cloth on water in the last step, on faces [N/m3]
  Points<Dim> positions;                          ///< X^n of this rank's markers [m]
  Points<Dim> velocities;                         ///< U^n [m/s]
  ContactLoads<Dim> contact_loads;                ///< of this rank's markers in the last step
  Point<Dim> wall_reaction = Point<Dim>::Zero();  ///< part of the cloth's force that walls took in the last step [N]
  double cloth_iterations = 0;                    ///< evaluations of the cloths' equations so far
  double cloth_slip = 0;  ///< rms difference of cloth and water over the rms speed of cloth in the last step
};

extern template struct SystemOptions<2>;
extern template struct SystemOptions<3>;
extern template struct System<2>;
extern template struct System<3>;

}  // namespace washfsi
