// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/model.hpp"
#include "washfsi/support/clock.hpp"

namespace washfsi {

/// The state of the cloths at a time. With the water's fields, which `Model::fluid` stores, all that a step starts
/// from.
template <int Dim>
struct State {
  Clock clock;
  Points<Dim> positions;            ///< X^n of this rank's markers [m]
  Points<Dim> velocities;           ///< V^n [m/s]
  Points<Dim> velocities_before;    ///< V^(n-1); V^n before the first step [m/s]
  Points<Dim> mean_velocities;      ///< W = (X^n - X^(n-1))/dt; V^n before the first step [m/s]
  Points<Dim> forces_before;        ///< F(X^(n-1)) of `Forces::of_places` without inertia, if the scheme needs it [N]
  Points<Dim> slips, slips_before;  ///< s^n and s^(n-1) along cloth with a wall model [m/s]
  Points<Dim> water_forces;         ///< F_f of the last step of cloth with a wall model [N]
};

/// The results of a step for measures, and the cost of all steps.
template <int Dim>
struct StepRecord {
  petsc::Vector force;                            ///< force density of cloth on water, on faces [N/m3]
  Points<Dim> evaluated_at;                       ///< places at which the forces on the cloths were evaluated last [m]
  double end_share = 1;                           ///< weight of the forces at those places in the mean force
  ContactLoads<Dim> contact_at_start;             ///< this rank's contact loads at the start, with the other weight
  Points<Dim> force_on_water;                     ///< force of each of this rank's markers on the water [N]
  Point<Dim> side_reaction = Point<Dim>::Zero();  ///< part of the cloth's force that sides of the box took [N]
  /// Power lost by seepage through cloth [W; W/m in the plane]; with a wall model that of all slip of cloth, what the
  /// water that it holds stores included.
  double seepage_power = 0;
  double cloth_slip = 0;        ///< rms difference of cloth and water over the rms speed of cloth
  double cloth_iterations = 0;  ///< evaluations of the cloths' equations in all steps so far
};

/// Water, bodies and cloth in motion.
template <int Dim>
struct System {
  /// Creates a system at rest, with the cloths' markers where `place` puts them, all of them in marker order.
  /// Collective. Errors: InputError.
  System(MPI_Comm comm, const ModelOptions<Dim>& options, std::vector<Body<Dim>> bodies,
         const std::function<Points<Dim>(const Model<Dim>&)>& place)
      : model(comm, options, std::move(bodies)) {
    const Points<Dim> all = place(model);
    state.positions.assign(all.begin() + model.cloths.begin(), all.begin() + model.cloths.end());
    for (std::size_t m = 0; m < state.positions.size(); ++m)
      state.velocities.push_back(model.cloths.group_of(m).velocity);
    state.velocities_before = state.mean_velocities = state.velocities;
    state.forces_before.assign(state.positions.size(), Point<Dim>::Zero());
    state.slips = state.slips_before = state.water_forces = state.forces_before;
    step.force = model.grid.face_vector();
    step.evaluated_at = state.positions;
    step.force_on_water.assign(state.positions.size(), Point<Dim>::Zero());
    model.add_forces(options, state.positions);
    model.locate_cloth(state.positions);
  }

  Model<Dim> model;
  State<Dim> state;
  StepRecord<Dim> step;
};

}  // namespace washfsi
