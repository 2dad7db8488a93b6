// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"

namespace washfsi {

/// How far the cloths' motion in the last step is from that of an embedded scheme of second order, the trapezoidal
/// rule [m/s]:
///   e = rms | (X^n - X^(n-1))/dt - (V^n + V^(n-1))/2 |   over the markers
/// For the schemes of first order this is half the change of velocity in a step, their error; the implicit coupling's
/// trapezoidal steps are that rule. 0 without cloth. Collective.
template <int Dim>
double step_error(const System<Dim>& system);

extern template double step_error<2>(const System<2>&);
extern template double step_error<3>(const System<3>&);

}  // namespace washfsi
