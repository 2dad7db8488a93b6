// SPDX-License-Identifier: BSD-3-Clause
//
// Checks that a step has left a state with which a run can go on.
#pragma once

#include <string>

#include "washfsi/coupling/system.hpp"
#include "washfsi/simulation/options.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

/// Checks that all markers of cloths are in the box; without water, that their places are finite. Collective. Errors:
/// DivergedError.
template <int Dim>
void check_markers(const System<Dim>& system);

/// Checks the largest CFL number of a step against -time_max_cfl. Errors: DivergedError.
void check_velocity(const Located& courant, const RunOptions& run);

/// Says where a run that has diverged came nearest to its limits: the tightest contact, and the place of the CFL number
/// that was seen last. Collective.
template <int Dim>
std::string where_it_failed(const Model<Dim>& model, const Located& courant);

extern template void check_markers<2>(const System<2>&);
extern template void check_markers<3>(const System<3>&);
extern template std::string where_it_failed<2>(const Model<2>&, const Located&);
extern template std::string where_it_failed<3>(const Model<3>&, const Located&);

}  // namespace washfsi
