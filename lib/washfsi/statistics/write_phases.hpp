// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/statistics/phase_statistics.hpp"

namespace washfsi {

/// Writes FOLDER/phases.h5. Collective. Errors: FileError.
void write_phases(const PhaseStatistics& phases, const std::string& folder);

}  // namespace washfsi
