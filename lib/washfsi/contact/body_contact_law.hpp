// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

/// The law by which the pressure of a surface grows with nearness.
enum class BodyContactLaw { quadratic, barrier };

/// The parameters of contact with bodies.
struct BodyContactOptions {
  double pressure = 0;     ///< p_0 of the penalty, at the surface, or kappa of the barrier [Pa]; 0: no contact force
  double distance = 0.01;  ///< contact distance, d_0 of the penalty or d^ of the barrier [m]
  BodyContactLaw law = BodyContactLaw::quadratic;
  double friction = 0;  ///< mu_C, coefficient of friction
  double damping = 0;   ///< zeta, damping of the normal motion over the critical one, in implicit steps
};

/// The action of a surface per undeformed area at a distance from a surface.
struct BodyPush {
  double energy = 0, pressure = 0, stiffness = 0;  ///< [J/m2, Pa, N/m3]
};
/// The action for the contact distance `begins` [m]. Below the share `soft` of that, w_kappa of the theory, the barrier
/// is a parabola.
BodyPush body_push(const BodyContactOptions& options, double distance, double begins, double soft = 0);

}  // namespace washfsi
