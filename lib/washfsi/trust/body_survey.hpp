// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/step_bound.hpp"

namespace washfsi {

/// A body as the grid resolves it at one moment.
template <int Dim>
struct BodySurvey {
  double cells = 0;                          ///< number of cells whose middles are in it
  double volume = 0;                         ///< volume of these [m3; m2 in the plane]
  Point<Dim> lower, upper;                   ///< box round these, for one image where it repeats itself [m]
  double top_speed = 0;                      ///< upper bound of the speed of its surface [m/s]
  double reach = 0;                          ///< largest distance of its surface from its centre [m]
  double thickness = 0;                      ///< cells across its thinnest tenth; at most `most_cells`
  double sheet_width = most_cells;           ///< cells along its thin parts from edge to edge, likewise
  double nearest = 0;                        ///< least distance of a cell's middle from it, negative inside [m]
  std::vector<double> shared;                ///< cells that it shares with each body
  static constexpr double most_cells = 8;    ///< largest value of both
  static constexpr double thin_cells = 1.4;  ///< below this a part is thin; a sheet of markers acts 1.3 cells thick
};

/// Surveys each body. Collective.
template <int Dim>
std::vector<BodySurvey<Dim>> survey_bodies(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, double time);

}  // namespace washfsi
