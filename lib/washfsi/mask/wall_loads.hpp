// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/viscous_stress.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/motion/load.hpp"

namespace washfsi {

/// The sides that are walls or slip and not covered everywhere, at all times, by bodies that rest or only turn.
/// Collective.
template <int Dim>
std::vector<SideName> exposed_walls(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                    const std::vector<Body<Dim>>& bodies);

/// Load of the water on the part of each of these sides that no body covers: pressure and friction; torques about the
/// middle of the box. The velocity [m/s], at `time`, is local, of face_dm, its ghosts filled; the
/// pressure [Pa] is global. Collective.
template <int Dim>
Loads<Dim> wall_loads(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
                      const std::vector<SideName>& sides, Vec local_velocity, Vec pressure, const Viscosity& viscosity,
                      double time);

}  // namespace washfsi
