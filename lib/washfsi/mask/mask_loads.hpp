// SPDX-License-Identifier: BSD-3-Clause
//
// Loads of the water on the bodies, from the faces of the grid.
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/grid/viscous_stress.hpp"
#include "washfsi/mask/mask.hpp"
#include "washfsi/motion/load.hpp"

namespace washfsi {

/// Load on each body from the constraint force density of the bodies over a step, null if there is none, less the
/// inertia of the water inside them, and the pressure on sides of the box that bodies cover. `time` is the middle of
/// the step. Collective.
template <int Dim>
Loads<Dim> constraint_loads(const Mask<Dim>& mask, Vec constraint_force, Vec density, Vec pressure, double time);

/// The momentum of the water inside each body relative to rigid motion with it, and its angular momentum about the
/// body's centre. Its growth over a step, over dt, must be added to `constraint_loads` on a body behind whose walls
/// water lags or slides. Collective.
template <int Dim>
Loads<Dim> inner_momentum(const Mask<Dim>& mask, Vec velocity, Vec density, double time);

/// Energy that the water lost in a step of dt to the moving mask: 1/2 rho |u_solid - u|^2 on the faces
/// that are solid now, u the velocity before, over dt [W; in the plane W/m]. An effect of the staircase. Collective.
template <int Dim>
double mask_dissipation(const Mask<Dim>& mask, Vec velocity_before, Vec density, double dt);

/// The drag of the box's sides at rest on the water inside each body, which is not the body's; to be added to
/// `constraint_loads` where a body moves along a side. The velocity is that at `time`, local, of face_dm, its ghosts
/// filled. Collective.
template <int Dim>
Loads<Dim> hidden_wall_shear(const Mask<Dim>& mask, const Boundary<Dim>& boundary, Vec local_velocity,
                             const Viscosity& viscosity, double time);

}  // namespace washfsi
