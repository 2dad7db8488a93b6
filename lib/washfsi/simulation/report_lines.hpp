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

/// A note that a run to this time [s] is a demonstration, if it ends before the second cycle is complete; else empty.
std::vector<std::string> demonstration_lines(const Cycles& cycles, double end);

/// The terminal's lines at the end: cost, and the main figures.
template <int Dim>
std::vector<std::string> result_lines(const System<Dim>& system, const Measures<Dim>& measures,
                                      const RunSummary& summary);

/// Means over the cycles, with their spread; empty without cycles.
std::vector<std::string> cycle_lines(const Cycles& cycles);

/// The findings: all of them, or only those that are not ok or always shown.
std::vector<std::string> trust_lines(const Findings& findings, bool all);

}  // namespace washfsi
