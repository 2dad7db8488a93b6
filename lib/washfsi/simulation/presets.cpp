// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/presets.hpp"

#include "washfsi/support/text.hpp"

namespace washfsi {

const PresetOptions& preset_options() {
  static const PresetOptions presets{// bodies that turn to and fro among many cloths
                                     {"machine",
                                      {{"body_slip_tolerance", "5e-4"},  // slip lags as the stroke turns
                                       {"coupling_tolerance", "1e-4"},   // the iteration's error is below that slip
                                       {"time_tolerance", "5e-4"},       // shorter steps where cloths hit vanes
                                       {"time_cfl", "0.55"}}}};          // and where the water is faster
  return presets;
}

void declare_preset(OptionBlock& block) {
  std::string preset = "none",
              help = "options that we recommend for a kind of case; any that is given beside it counts more";
  std::vector<std::string> names{preset};
  for (const auto& [name, options] : preset_options()) {
    std::vector<std::string> words;
    for (const auto& [option, value] : options) words.push_back("-" + option + " " + value);
    names.push_back(name);
    help += ". " + name + ": " + join(words, ", ");
  }
  block.choice("preset", preset, names, help.c_str());
}

}  // namespace washfsi
