// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/measure/measures.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// What can be said of a run after its last step: energy, steps, cloth, how much cycles differ.
template <int Dim>
Findings end_findings(const System<Dim>& system, const Measures<Dim>& measures);

}  // namespace washfsi
