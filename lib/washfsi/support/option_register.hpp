// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "washfsi/support/declared_options.hpp"
#include "washfsi/support/given_options.hpp"
#include "washfsi/support/left_out_options.hpp"
#include "washfsi/support/old_option_names.hpp"

namespace washfsi {

/// What is known of the options of a run: what the user gave, and what the program has asked for so far.
struct OptionRegister {
  bool help = false;   ///< whether the user asked for -help or a document
  GivenOptions given;  ///< where PETSc's options come from
  OldOptionNames old_names;
  DeclaredOptions declared;
  LeftOutOptions left_out;
  std::map<std::string, std::string> answers;  ///< messages for options that do not exist
};

}  // namespace washfsi
