// SPDX-License-Identifier: BSD-3-Clause
//
// The acceleration that a coupling scheme assigns to a marker in a step, from its mean velocity W = (X^(n+1) - X^n)/dt
// there and from earlier velocities. The inertia of the cloth's own mass is minus the mass times this acceleration.
#pragma once

#include "washfsi/coupling/system.hpp"

namespace washfsi {

/// Second backward difference (BDF2) of the velocities V = W, taken at the ends of the steps. With chi the ratio of
/// this step to the last, the acceleration is
///   ( (1 + 2 chi)/(1 + chi) W - (1 + chi) V^n + chi^2/(1 + chi) V^(n-1) )/dt
/// The first step follows one of its own length without acceleration. So the impulses of equal steps add up to what the
/// momentum of 3/2 V^n - 1/2 V^(n-1) changes by, whatever the first step is.
template <int Dim>
Acceleration<Dim> backward_difference(const System<Dim>& system, double dt);

/// (V^(n+1) - V^n)/dt, with W the mean of the two velocities.
template <int Dim>
Acceleration<Dim> trapezoidal_difference(const System<Dim>& system, double dt);

/// (V^(n+1) - V^n)/dt, with the velocity at the end extrapolated from the means W of this step and the last, taken in
/// the middle of each: centred, and for equal steps the second backward difference of W.
template <int Dim>
Acceleration<Dim> centred_difference(const System<Dim>& system, double dt);
/// Returns that extrapolated V^(n+1) from W.
template <int Dim>
Points<Dim> extrapolated(const System<Dim>& system, double dt, const Points<Dim>& mean_velocities);

}  // namespace washfsi
