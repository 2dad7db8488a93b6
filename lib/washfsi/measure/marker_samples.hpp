// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/measure/marker_quantities.hpp"

namespace washfsi {

/// Samples the cloths after a step: the state of each of this rank's markers, and the washing action on it, which is 0
/// without water. Collective.
template <int Dim>
std::vector<MarkerSample> marker_samples(const System<Dim>& system);

}  // namespace washfsi
