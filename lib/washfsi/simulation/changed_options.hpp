// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace washfsi {

/// The lines of a text of resolved options that make up the case: how long a run takes and what it writes is no part of
/// it.
std::string case_options(const std::string& resolved);

/// Such a text without the checkpoint that the run went on from, which later ones replace: so that it repeats the run.
std::string repeatable(const std::string& resolved);

/// What a restart changes of a case, from two such texts: a line for each option. Nothing if the first is empty.
std::vector<std::string> changed_options(const std::string& before, const std::string& now);

}  // namespace washfsi
