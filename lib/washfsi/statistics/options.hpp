// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "washfsi/statistics/sampling.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// The options of means along homogeneous axes.
struct StatisticsOptions {
  bool take = false;
  std::vector<std::string> axes = {};  ///< "x", "y", "z", along which means are taken; none: all periodic ones
  double start = 0;                    ///< start of sampling [s]
  double interval = 0;                 ///< interval between samples [s]; 0: each step
  std::vector<double> spectra = {};    ///< places on the inhomogeneous axis where spectra are taken [m]

  static StatisticsOptions from_options(Options& options);
};

/// The options of means over the cycles of a machine, phase by phase.
struct PhaseOptions {
  PetscInt count = 0;                             ///< number of equal phases in a period; 0: no means
  double period = 0;                              ///< period [s]; 0: that of the cycles
  Sampling sampling = {};                         ///< sampling, as of the other statistics
  int axis = 2;                                   ///< direction of the machine's axis
  std::optional<Point<3>> center = std::nullopt;  ///< a place on it [m]; none: the bodies' centre
  std::array<PetscInt, 2> bins = {0, 0};          ///< numbers of bins of radius and along the axis; 0: a cell wide

  /// Reads them in this number of dimensions. Errors: InputError.
  static PhaseOptions from_options(Options& options, const StatisticsOptions& others, int dimension);
};

}  // namespace washfsi
