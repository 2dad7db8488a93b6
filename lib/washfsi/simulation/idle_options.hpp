// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/simulation/case.hpp"

namespace washfsi {

/// Marks the options that have no effect because of options of other parts: without water, cloths or bodies, and with
/// the chosen coupling. Those that depend on options of their own part only are marked there.
template <int Dim>
void mark_idle_options(Options& options, const CaseOptions<Dim>& chosen, const std::vector<Body<Dim>>& bodies);

}  // namespace washfsi
