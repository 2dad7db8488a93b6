// SPDX-License-Identifier: BSD-3-Clause
//
// The loads that follow from the forces of the markers.
#pragma once

#include "washfsi/motion/load.hpp"
#include "washfsi/wall_forces/wall_forces.hpp"

namespace washfsi {

/// The load of the water on each body, about its centre: -F, less what the sides of the box that the bodies stand on
/// took of it, and the friction of the law of the wall. Collective.
template <int Dim>
Loads<Dim> marker_loads(const WallForces<Dim>& walls);

/// What these sides of the box took of the markers' forces where no body stands on them; torques about the middle of
/// the box. Collective.
template <int Dim>
Loads<Dim> marker_loads_on_sides(const WallForces<Dim>& walls, const std::vector<SideName>& sides);

/// The power that the bodies gave over the last step of dt and the water did not get, because its velocities at the
/// markers, `before` and `after` the step, were others than theirs: F (U(t + dt/2) - J (u^n + u^(n+1))/2) [W; W/m in
/// the plane]. Collective.
template <int Dim>
double lost_power(const WallForces<Dim>& walls, const Points<Dim>& before, const Points<Dim>& after, double dt);

/// The slip of the water at each body's markers, root mean square [m/s], without that which a law of friction allows.
/// The solver reduces its means over the reach of a kernel, which are smaller. Collective.
template <int Dim>
std::vector<double> slip_of_bodies(const WallMarkers<Dim>& markers, const Points<Dim>& water);

}  // namespace washfsi
