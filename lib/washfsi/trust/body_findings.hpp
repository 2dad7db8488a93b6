// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/trust/body_survey.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// Findings on the bodies before the first step: whether all are in the box and thick enough, and whether they move as
/// machines do. Errors: InputError for a drum whose wall misses the box. Collective.
template <int Dim>
Findings body_findings(const Model<Dim>& model, const std::vector<BodySurvey<Dim>>& surveys, double time);

}  // namespace washfsi
