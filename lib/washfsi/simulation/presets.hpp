// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/command_line.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// Kinds of cases for which we recommend numerics of their own.
enum class Preset {
  none,
  machine,  ///< bodies that turn to and fro among many cloths
};
const ChoiceNames<Preset>& names_of(Preset);

/// The options that each preset stands for.
const PresetOptions& preset_options();

/// Declares and checks -preset, whose options the command line has put before all others already. Errors: InputError.
void declare_preset(OptionBlock& block);

}  // namespace washfsi
