// SPDX-License-Identifier: BSD-3-Clause
//
// Loads on bodies and sides from the forces of the markers.
#pragma once

#include "washfsi/motion/load.hpp"
#include "washfsi/wall_forces/wall_forces.hpp"

namespace washfsi {

/// The load of the water on each body, about its centre: -F, less the part that sides of the box beneath the body took,
/// plus the friction of the law of the wall. Collective.
template <int Dim>
Loads<Dim> marker_loads(const WallForces<Dim>& walls);

/// The part of the markers' forces that these sides of the box took where no body stands on them; torques about the
/// middle of the box. Collective.
template <int Dim>
Loads<Dim> marker_loads_on_sides(const WallForces<Dim>& walls, const std::vector<SideName>& sides);

/// The power that the bodies gave over the last step of dt but the water did not receive, because it slipped at the
/// markers: F . (U_solid(t + dt/2) - J (u^n + u^(n+1))/2), with J u `before` and `after` the step [W; W/m in 2D].
/// Collective.
template <int Dim>
double lost_power(const WallForces<Dim>& walls, const Points<Dim>& before, const Points<Dim>& after, double dt);

/// The rms slip of the water at each body's markers [m/s], without the slip that a law of friction allows. The solver
/// reduces the filtered slip, which is smaller. Collective.
template <int Dim>
std::vector<double> slip_of_bodies(const WallMarkers<Dim>& markers, const Points<Dim>& water);

}  // namespace washfsi
