// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "washfsi/support/options.hpp"

namespace washfsi {

/// Values along warp (s) and weft (r).
using WarpWeft = std::array<double, 2>;

/// Reads a list of one number, for both directions, or of as many as there are; each must be in the range. The value of
/// a direction that there is not stays as it is.
inline void read_warp_weft(OptionBlock& block, const char* name, WarpWeft& value, std::size_t directions,
                           const char* unit, const Range& range, const std::string& help) {
  std::vector<double> list(value.begin(), value.begin() + static_cast<long>(directions));
  block.reals(name, list, 1, directions, unit,
              (directions == 1 ? help : help + " along warp and weft; one number for both").c_str());
  for (std::size_t d = 0; d < directions; ++d) {
    value[d] = list[std::min(d, list.size() - 1)];
    if (!range.contains(value[d])) block.refuse(name, to_text(value[d]), range.text);
  }
}

}  // namespace washfsi
