// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/simulation/case.hpp"

namespace washfsi {

/// Marks the options that have no effect as options of other parts stand: without water, cloths or bodies, and with the
/// chosen coupling. What depends on options of one part alone is marked there.
template <int Dim>
void mark_idle_options(Options& options, const CaseOptions<Dim>& chosen, const std::vector<Body<Dim>>& bodies);

}  // namespace washfsi
