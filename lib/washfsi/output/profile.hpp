// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/grid/boundary.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// A straight line along which velocity and pressure are sampled at the end of a run.
template <int Dim>
struct Profile {
  std::string name;
  Point<Dim> from = Point<Dim>::Zero(), to = Point<Dim>::Zero();  ///< [m]
  PetscInt points = 101;

  /// Writes FOLDER/profiles/NAME.csv by linear interpolation; ghosts give the exact velocity of walls. Collective.
  void write(const Grid<Dim>& grid, const Boundary<Dim>& boundary, Vec velocity, Vec pressure, double time,
             const std::string& folder) const;
};

/// The lines named by -profiles. Errors: InputError, also for lines that leave the box.
template <int Dim>
std::vector<Profile<Dim>> profiles_from_options(Options& options, const Point<Dim>& lower, const Point<Dim>& upper);

}  // namespace washfsi
