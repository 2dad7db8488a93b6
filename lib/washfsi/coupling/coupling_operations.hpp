// SPDX-License-Identifier: BSD-3-Clause
//
// The operations that coupling schemes compose. All are collective.
#pragma once

#include "washfsi/coupling/system.hpp"

namespace washfsi {

/// Prepares the forces for a step: each searches for contacts near these positions. The forces will act at `time`;
/// until then, for `dt`, markers accelerate as given. `share` is the weight of these forces in the step's mean force.
template <int Dim>
void begin_step(System<Dim>& system, const Points<Dim>& positions, double time, double dt,
                const Acceleration<Dim>& acceleration = {}, double share = 1);

/// Begins an explicit step: forces at these places and this time, constant over dt. Locates the cloth.
template <int Dim>
void begin_explicit_step(System<Dim>& system, const Points<Dim>& positions, double time, double dt);

/// Returns all forces at these places, and notes the places as those evaluated last.
template <int Dim>
Points<Dim> all_forces(System<Dim>& system, const Points<Dim>& positions);

/// Spreads the forces from where the cloth was located last into the step's force density.
template <int Dim>
void spread_cloth(System<Dim>& system, const Points<Dim>& forces);

/// Places the bodies as they are at `time`.
template <int Dim>
void place_bodies(System<Dim>& system, double time);

/// Phases 1 and 2 of the fluid's step with the liquid and the bodies as they are, and the step's force density.
template <int Dim>
void predict_water(System<Dim>& system, double dt);
/// All phases but the last, for schemes without further forces.
template <int Dim>
void move_water(System<Dim>& system, double dt);

/// U = J [H u + (1-H) u_solid] for a velocity at `time` and the bodies as they were placed last.
template <int Dim>
Points<Dim> marker_velocities(const Model<Dim>& model, Vec velocity, double time);

/// Returns X plus a motion, shortened by the step limit for markers that would go through a cloth. What the forces have
/// found near the markers is valid at the new places too.
template <int Dim>
Points<Dim> moved(System<Dim>& system, const Points<Dim>& motion);

/// Sum of products, and 2-norm, over all markers of all ranks.
template <int Dim>
double dot(MPI_Comm comm, const Points<Dim>& a, const Points<Dim>& b);
template <int Dim>
double norm(MPI_Comm comm, const Points<Dim>& values);

}  // namespace washfsi
