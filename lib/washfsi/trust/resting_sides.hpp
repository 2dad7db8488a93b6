// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/model.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// Findings on sides of the box that rest although they close a body that moves round the water, as the ends of a
/// turning drum: one for each, none without such sides. Collective.
template <int Dim>
Findings resting_side_findings(const Model<Dim>& model, double time);

}  // namespace washfsi
