// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/command_line.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// The options that each preset stands for; each is for a kind of case for which we recommend numerics of its own.
const PresetOptions& preset_options();

/// Declares and checks -preset, whose options the command line has put before all others already. Errors: InputError.
void declare_preset(OptionBlock& block);

}  // namespace washfsi
