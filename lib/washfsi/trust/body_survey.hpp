// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/step_bound.hpp"

namespace washfsi {

/// What the grid sees of a body at one moment.
template <int Dim>
struct BodySurvey {
  double cells = 0;                          ///< whose middles are in it
  double volume = 0;                         ///< of these [m3; m2 in the plane]
  Point<Dim> lower, upper;                   ///< box round these, of one image where it repeats itself [m]
  double top_speed = 0;                      ///< never exceeded by its material at its surface [m/s]
  double reach = 0;                          ///< of its surface from its centre [m]
  double thickness = 0;                      ///< cells across its thinnest tenth; at most `most_cells`
  double sheet_width = most_cells;           ///< cells along its thin parts from edge to edge, likewise
  double nearest = 0;                        ///< least distance of a cell's middle from it, negative inside [m]
  std::vector<double> shared;                ///< cells that it shares with each body
  static constexpr double most_cells = 8;    ///< beyond which neither is looked at
  static constexpr double thin_cells = 1.4;  ///< as thick as a sheet of markers acts
};

/// Of each body. Collective.
template <int Dim>
std::vector<BodySurvey<Dim>> survey_bodies(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, double time);

}  // namespace washfsi
