// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/options.hpp"

namespace washfsi {

/// Of what, when and where statistics are taken.
struct StatisticsOptions {
  bool take = false;
  std::vector<std::string> axes = {};  ///< "x", "y", "z", along which means are taken; none: all periodic ones
  double start = 0;                    ///< [s]
  double interval = 0;                 ///< between samples [s]; 0: each step
  std::vector<double> spectra = {};    ///< places on the axis that is left where spectra are taken [m]

  static StatisticsOptions from_options(Options& options);
};

}  // namespace washfsi
