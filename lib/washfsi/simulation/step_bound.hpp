// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/simulation/system.hpp"

namespace washfsi {

/// The longest explicit step [s] for the cloth as it lies: with the mobility m_k of each marker, the stiffest
/// oscillation of its sheet has the frequency w, for a fibre w^2 = 4 m_k (Ke/ds^2 + 4 Kb/ds^4), and the damped explicit
/// step needs dt^2 + 2 beta dt < (2/w)^2. Without damping and bending this is dt < ds/sqrt(Ke m_k), which is about
/// twice on the safe side. Infinite without cloth. Needs `transfer.locate`. Collective.
template <int Dim>
double cloth_step_bound(const System<Dim>& system);

/// The time in which the largest speed that boundary, bodies or the present flow prescribe crosses a cell [s]: the step
/// of CFL number 1; infinite at rest. Collective.
template <int Dim>
double flow_time(const System<Dim>& system);

}  // namespace washfsi
