// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "washfsi/coupling/delta.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

DeltaOptions DeltaOptions::from_options(Options& options) {
  DeltaOptions delta;
  std::string kernel = "cosine";
  constexpr Range widths{1.5, 4, false, "1.5, 2, 3 or 4"};
  options.block("delta_", "Regularised delta", [&](OptionBlock& block) {
    block.choice("kernel", kernel, {"cosine"}, "shape of the regularised delta");
    block.real("spread_width", delta.spread_width, "cells", widths, "half width for spreading forces and mass");
    block.real("interpolate_width", delta.interpolate_width, "cells", widths, "half width for the markers' velocity");
  });
  for (const double width : {delta.spread_width, delta.interpolate_width})
    if (width != 1.5 && width != 2 && width != 3 && width != 4)
      throw InputError("-delta_spread_width, -delta_interpolate_width " + to_text(width) + ": must be 1.5, 2, 3 or 4");
  return delta;
}

}  // namespace washfsi
