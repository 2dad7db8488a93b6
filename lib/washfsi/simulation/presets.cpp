// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/presets.hpp"

namespace washfsi {

const ChoiceNames<Preset>& names_of(Preset) {
  static const ChoiceNames<Preset> names{{"none", Preset::none}, {"machine", Preset::machine}};
  return names;
}

const PresetOptions& preset_options() {
  static const PresetOptions presets{{"machine",
                                      {{"body_slip_tolerance", "5e-4"},  // slip lags as the stroke turns
                                       {"coupling_tolerance", "1e-4"},   // the iteration's error is below that slip
                                       {"time_tolerance", "5e-4"},       // shorter steps where cloths hit vanes
                                       {"time_cfl", "0.55"}}}};          // and where the water is faster
  return presets;
}

void declare_preset(OptionBlock& block) {
  Preset preset = Preset::none;
  block.choice("preset", preset,
               "options that we recommend for a kind of case; any that is given beside it counts more. machine: "
               "-body_slip_tolerance 5e-4, -coupling_tolerance 1e-4, -time_tolerance 5e-4, -time_cfl 0.55");
}

}  // namespace washfsi
