// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"

namespace washfsi {

/// The error of the cloths' motion in the last step: its difference from that of an embedded scheme of second order,
/// the trapezoidal rule [m/s]. With W the mean velocity of a marker in that step,
///   error = rms | W - (V^(n-1) + V^n)/2 |   over the markers
/// For the schemes of first order this is half the change of velocity in a step. The trapezoidal steps of the implicit
/// coupling are that rule. 0 without cloth. Collective.
template <int Dim>
double step_error(const System<Dim>& system);

extern template double step_error<2>(const System<2>&);
extern template double step_error<3>(const System<3>&);

}  // namespace washfsi
