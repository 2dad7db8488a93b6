// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/trust/body_survey.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// What can be said of the bodies before the first step: whether they are in the box, all of them, and thick enough,
/// and whether they move as machines do. Errors: InputError of a drum whose wall passes the box by. Collective.
template <int Dim>
Findings body_findings(const Model<Dim>& model, const std::vector<BodySurvey<Dim>>& surveys, double time);

}  // namespace washfsi
