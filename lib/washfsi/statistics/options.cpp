// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/statistics/options.hpp"

#include "washfsi/support/errors.hpp"

namespace washfsi {

StatisticsOptions StatisticsOptions::from_options(Options& options) {
  StatisticsOptions statistics;
  options.block("", "Statistics", [&](OptionBlock& block) {
    block.boolean("statistics", statistics.take, "take means of velocity and pressure, stresses and spectra");
    block.names("statistics_axes", statistics.axes,
                "axes along which the flow is homogeneous: means are taken along them; none given: all periodic ones");
    block.real("statistics_start", statistics.start, "s", non_negative,
               "time from which they are taken; 0: from the first step");
    block.real("statistics_interval", statistics.interval, "s", non_negative,
               "between samples, each weighed with the time since the one before; 0: each step");
    block.reals("statistics_spectra", statistics.spectra, 0, 20, "m",
                "places on the only axis without mean at which spectra along the others are taken");
  });
  if (!statistics.take) options.mark_idle("-statistics is false", {"statistics_axes", "statistics_spectra"});
  return statistics;
}

namespace {

constexpr Range few{0, 1000, false, "a whole number from 0 to 1000"};

std::optional<Point<3>> read_center(OptionBlock& block) {
  const std::string name = "statistics_phase_center";
  std::vector<double> center;
  block.reals(name, center, 0, 3, "m",
              "a place on the machine's axis; none given: the centre of the first body that turns, else -machine_axis");
  if (center.empty()) return std::nullopt;
  if (center.size() == 3) return Point<3>(center.data());
  std::vector<std::string> words;
  for (const double number : center) words.push_back(to_text(number));
  block.refuse(name, join(words, ","), "three numbers, or none");
}

void read_axis(OptionBlock& block, PhaseOptions& phases) {
  const std::vector<std::string> axes{"x", "y", "z"};
  std::string axis = "z";
  block.choice("statistics_phase_axis", axis, axes, "direction of the machine's axis; bodies turn about z");
  phases.axis = static_cast<int>(std::ranges::find(axes, axis) - axes.begin());
  phases.center = read_center(block);
}

}  // namespace

PhaseOptions PhaseOptions::from_options(Options& options, const StatisticsOptions& others, int dimension) {
  PhaseOptions phases;
  phases.sampling = {others.start, others.interval};
  options.block("", "Phase averages", [&](OptionBlock& block) {
    block.integer(
        "statistics_phases", phases.count, few,
        "number of equal phases of a period, of each of which the mean flow round an axis is taken in 3D; 0: none");
    block.real("statistics_phase_period", phases.period, "s", non_negative, "the period; 0: that of the cycles");
    read_axis(block, phases);
    block.integer("statistics_phase_bins_r", phases.bins[0], few, "bins of the radius; 0: each a cell wide");
    block.integer("statistics_phase_bins_z", phases.bins[1], few, "bins along the axis; 0: each a cell wide");
  });
  if (phases.count > 0 && dimension == 2)
    throw InputError("-statistics_phases " + std::to_string(phases.count) + ": needs three dimensions");
  if (phases.count == 0) options.mark_idle("-statistics_phases is 0", {"statistics_phase_*"});
  if (phases.count == 0 && !others.take)
    options.mark_idle("neither -statistics nor -statistics_phases are taken",
                      {"statistics_start", "statistics_interval"});
  return phases;
}

}  // namespace washfsi
