// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>

#include "washfsi/immersed_boundary/delta.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

const ChoiceNames<DeltaKernel>& names_of(DeltaKernel) {
  static const ChoiceNames<DeltaKernel> names{{"cosine", DeltaKernel::cosine},
                                              {"roma", DeltaKernel::roma},
                                              {"yang", DeltaKernel::yang},
                                              {"peskin", DeltaKernel::peskin},
                                              {"bao", DeltaKernel::bao}};
  return names;
}

DeltaOptions DeltaOptions::from_options(Options& options) {
  static const std::map<DeltaKernel, double> own_width{
      {DeltaKernel::roma, 1.5}, {DeltaKernel::yang, 2}, {DeltaKernel::peskin, 2}, {DeltaKernel::bao, 3}};
  DeltaOptions delta;
  constexpr Range widths{1.5, 4, false, "1.5, 2, 3 or 4"};
  options.block("delta_", "Regularised delta", [&](OptionBlock& block) {
    block.choice("kernel", delta.kernel,
                 "shape of the regularised delta: the thesis's cosine; that of Roma, of half width 1.5, and the same "
                 "smoothed by Yang, of half width 2; Peskin's, of half width 2; the smoother one of Bao,"
                 " Kaye and Peskin, of half width 3");
    if (own_width.contains(delta.kernel)) delta.spread_width = delta.interpolate_width = own_width.at(delta.kernel);
    block.real("spread_width", delta.spread_width, "cells", widths, "half width for spreading forces and mass");
    block.real("interpolate_width", delta.interpolate_width, "cells", widths, "half width for the markers' velocity");
  });
  for (const auto& [name, width] :
       {std::pair{"spread", delta.spread_width}, {"interpolate", delta.interpolate_width}}) {
    const std::string option = "-delta_" + std::string(name) + "_width " + to_text(width);
    if (width != 1.5 && width != 2 && width != 3 && width != 4) throw InputError(option + ": must be 1.5, 2, 3 or 4");
    if (own_width.contains(delta.kernel) && width != own_width.at(delta.kernel))
      throw InputError(option + ": the delta of -delta_kernel " + name_of(delta.kernel) + " has the half width " +
                       to_text(own_width.at(delta.kernel)));
  }
  return delta;
}

}  // namespace washfsi
