// SPDX-License-Identifier: BSD-3-Clause
//
// The operations that coupling schemes compose. All are collective.
#pragma once

#include "washfsi/simulation/system.hpp"

namespace washfsi {

/// Forces that do not stem from the cloth's own deformation, at the bodies' present places: weight of the excess mass,
/// constant loads, contact with bodies [N; per unit depth in the plane]. Keeps the loads of contact on the bodies.
template <int Dim>
Points<Dim> external_forces(System<Dim>& system, const Points<Dim>& positions, double time);

/// All forces: of elasticity and the holding springs, of damping, and the external ones.
template <int Dim>
Points<Dim> all_forces(System<Dim>& system, const Points<Dim>& positions, const Points<Dim>& velocities, double time);

/// Fixes spread, interpolate and the density at these places, and spreads the forces into the system's force density.
template <int Dim>
void spread_cloth(System<Dim>& system, const Points<Dim>& positions, const Points<Dim>& forces);

/// Places the bodies as they are at `time`.
template <int Dim>
void hold_bodies(System<Dim>& system, double time);

/// Phases 1 to 3 of the fluid's step with the system's present density, force density and bodies.
template <int Dim>
void predict_and_project(System<Dim>& system, double dt);

/// U = J [H u + (1-H) u_solid] for a velocity at `time` and the bodies as they were placed last.
template <int Dim>
Points<Dim> marker_velocities(const System<Dim>& system, Vec velocity, double time);

/// 2-norm over all markers of all ranks.
template <int Dim>
double norm(MPI_Comm comm, const Points<Dim>& values);

/// a + factor b, marker by marker.
template <int Dim>
Points<Dim> sum(const Points<Dim>& a, double factor, const Points<Dim>& b);

}  // namespace washfsi
