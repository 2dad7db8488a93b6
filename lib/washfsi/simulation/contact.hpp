// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/mask.hpp"
#include "washfsi/cloth/cloths.hpp"
#include "washfsi/grid/boundary.hpp"

namespace washfsi {

/// A soft cushion on bodies and on the walls of the box that keeps cloth out of them: a marker nearer than `distance`
/// d0 is pushed along the outward normal with the force per undeformed area P0 ((d0 - Phi)/d0)^2. No-slip alone lets
/// markers drift into the staircase of the sharp mask.
struct ContactOptions {
  double pressure = 0;     ///< P0, at the surface [Pa]; 0: no contact force
  double distance = 0.01;  ///< d0 [m]

  static ContactOptions from_options(Options& options);
};

/// Loads of contact: on each body, about its centre, and on the lower and upper side of the box along each axis, about
/// the box's middle.
template <int Dim>
struct ContactLoads {
  Loads<Dim> bodies;
  std::array<std::array<Load<Dim>, 2>, Dim> sides{};
};

/// Contact force on each of this rank's markers [N; per unit depth in the plane] at `time`; adds the reaction of this
/// rank's markers to the loads. No communication.
template <int Dim>
Points<Dim> contact_forces(const ContactOptions& contact, const std::vector<Body<Dim>>& bodies,
                           const Boundary<Dim>& boundary, const Grid<Dim>& grid, const Cloths<Dim>& cloths,
                           const Points<Dim>& positions, double time, ContactLoads<Dim>& reactions);

}  // namespace washfsi
