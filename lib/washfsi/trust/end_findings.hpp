// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/measure/measures.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// Findings on a run after its last step: energy, steps, cloth, differences of cycles. `time_cfl` is the CFL number for
/// which its steps were chosen; 0 if they were of equal length.
template <int Dim>
Findings end_findings(const System<Dim>& system, const Measures<Dim>& measures, double time_cfl);

}  // namespace washfsi
