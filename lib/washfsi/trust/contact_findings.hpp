// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/trust/finding.hpp"

namespace washfsi {

/// Finds which cloths start in contact, with each other or with bodies and sides of the box. No communication.
template <int Dim>
Findings contact_findings(const System<Dim>& system);

}  // namespace washfsi
