// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/support/option_register.hpp"

namespace washfsi {

/// Stops if the user gave an option that nobody has read; PETSc's own options pass. Returns a line for each reason for
/// which options that the user gave are without effect: those that were left out or are idle. Errors: InputError.
std::vector<std::string> reject_unread_options(const OptionRegister& options);

}  // namespace washfsi
