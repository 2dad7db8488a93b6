// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/mask.hpp"
#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// A soft cushion on the bodies that keeps cloth out of them: a marker nearer than `distance` d0 to a body is pushed
/// along the body's outward normal with the force per undeformed length P0 ((d0 - Phi)/d0)^2. No-slip alone lets
/// markers drift into the staircase of the sharp mask.
struct ContactOptions {
  double pressure = 0;     ///< P0, at the surface [Pa]; 0: no contact force
  double distance = 0.01;  ///< d0 [m]

  static ContactOptions from_options(Options& options);
};

/// Contact force on each of this rank's markers [N; per unit depth in the plane] at `time`; adds the reaction of this
/// rank's markers to the loads of the bodies. No communication.
template <int Dim>
Points<Dim> contact_forces(const ContactOptions& contact, const std::vector<Body<Dim>>& bodies,
                           const Cloths<Dim>& cloths, const Points<Dim>& positions, double time,
                           std::vector<Load<Dim>>& reactions);

}  // namespace washfsi
