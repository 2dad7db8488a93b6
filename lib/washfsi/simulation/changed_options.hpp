// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace washfsi {

/// The lines of a text of resolved options that define the case, without those on the run's length and output.
std::string case_options(const std::string& resolved);

/// A text of resolved options that repeats a run: without the checkpoint from which it continued, which later ones
/// replace.
std::string repeatable(const std::string& resolved);

/// The options of a case that a restart changes, from two such texts: a line for each. Empty if the first text is
/// empty.
std::vector<std::string> changed_options(const std::string& before, const std::string& now);

}  // namespace washfsi
