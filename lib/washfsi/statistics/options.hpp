// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "washfsi/statistics/sampling.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// Of what, when and where means along homogeneous axes are taken.
struct StatisticsOptions {
  bool take = false;
  std::vector<std::string> axes = {};  ///< "x", "y", "z", along which means are taken; none: all periodic ones
  double start = 0;                    ///< [s]
  double interval = 0;                 ///< between samples [s]; 0: each step
  std::vector<double> spectra = {};    ///< places on the axis that is left where spectra are taken [m]

  static StatisticsOptions from_options(Options& options);
};

/// Of what, when and where means over the cycles of a machine are taken, phase by phase.
struct PhaseOptions {
  PetscInt count = 0;                             ///< of equal phases in a period; 0: none are taken
  double period = 0;                              ///< [s]; 0: that of the cycles
  Sampling sampling = {};                         ///< that of the other statistics
  int axis = 2;                                   ///< direction of the machine's axis
  std::optional<Point<3>> center = std::nullopt;  ///< a place on it [m]; none: that of the bodies
  std::array<PetscInt, 2> bins = {0, 0};          ///< of radius and along the axis; 0: a cell wide

  /// In this number of dimensions. Errors: InputError.
  static PhaseOptions from_options(Options& options, const StatisticsOptions& others, int dimension);
};

}  // namespace washfsi
