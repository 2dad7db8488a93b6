// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/simulation/results.hpp"

namespace washfsi {

/// The terminal's lines at the start of a run: case, grid, bodies, cloths, solvers.
template <int Dim>
std::vector<std::string> banner_lines(const Model<Dim>& model, const std::string& case_name,
                                      const std::string& coupling);

/// The line on time at the start of a run: length of its steps, its end, and the bound of the coupling [s], infinite if
/// it has none.
std::string time_line(double step, double end, double bound, bool has_cloths);

/// A note that a run to this time [s] is a demonstration, if it ends before the second cycle is complete; else empty.
std::vector<std::string> demonstration_lines(const Cycles& cycles, double end);

/// The findings: all of them, or only those that are not ok or always shown.
std::vector<std::string> trust_lines(const Findings& findings, bool all);

/// The terminal's lines at the end: cost, main figures, means over the cycles with their spread, findings, and the
/// folder that has the results.
template <int Dim>
std::vector<std::string> end_lines(const System<Dim>& system, const Measures<Dim>& measures, const RunSummary& summary,
                                   const std::string& folder);

}  // namespace washfsi
