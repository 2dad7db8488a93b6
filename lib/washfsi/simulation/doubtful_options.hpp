// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/simulation/case.hpp"

namespace washfsi {

/// Warns of values that no machine with water has, most likely given in another unit or along another axis.
template <int Dim>
void warn_of_doubtful_options(Options& options, const CaseOptions<Dim>& chosen, const std::vector<Body<Dim>>& bodies);

/// Warns of cycles and phases that pass between two steps [s].
template <int Dim>
void warn_of_short_spans(Options& options, const Measures<Dim>& measures, double step);

}  // namespace washfsi
