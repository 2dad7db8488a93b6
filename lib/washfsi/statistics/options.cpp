// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/options.hpp"

namespace washfsi {

StatisticsOptions StatisticsOptions::from_options(Options& options) {
  StatisticsOptions statistics;
  options.block("", "Statistics", [&](OptionBlock& block) {
    block.boolean("statistics", statistics.take, "take means of velocity and pressure, stresses and spectra");
    block.names("statistics_axes", statistics.axes,
                "axes along which the flow is homogeneous: means are taken along them; none given: all periodic ones");
    block.real("statistics_start", statistics.start, "s", non_negative, "time from which they are taken");
    block.real("statistics_interval", statistics.interval, "s", non_negative,
               "between samples, each weighed with the time since the one before; 0: each step");
    block.reals("statistics_spectra", statistics.spectra, 0, 20, "m",
                "places on the only axis without mean at which spectra along the others are taken");
  });
  return statistics;
}

}  // namespace washfsi
