// SPDX-License-Identifier: BSD-3-Clause
//
// Rings round the axis of a machine: bins of the radius R and of the place z along the axis, over all angles theta.
// Components along R, theta and z are right-handed: seen from the end of the axis theta is counter-clockwise.
#pragma once

#include <array>
#include <vector>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

class RingBins {
 public:
  /// `counts` are the numbers of bins of R and z, which cover all of the box; 0: as wide as a cell, in R as its longer
  /// side. Collective.
  RingBins(const Grid<3>& grid, int axis, const Point<3>& center, const std::array<PetscInt, 2>& counts);

  std::size_t count() const { return radii_.size() * heights_.size(); }
  double reach() const { return width_ * static_cast<double>(radii_.size()); }  ///< outer radius of the bins [m]
  const std::vector<double>& radii() const { return radii_; }                   ///< the bins' middles [m]
  const std::vector<double>& heights() const { return heights_; }  ///< middles along the axis, in the box [m]
  /// The number of cells whose centres are in a bin; bins are numbered with R fastest.
  double cells(std::size_t bin) const { return cells_[bin]; }

  /// The bin of a place, and its position there.
  struct Place {
    std::size_t bin;
    double aside;       ///< R' = R less that of the bin's middle, in widths of a bin
    Point<2> outwards;  ///< unit vector along R in the two directions that follow the axis; 0 on the axis
  };
  Place at(const Point<3>& place) const;
  /// Components of a vector at a place, along R, theta and z; on the axis only that along z, as R has no direction.
  Point<3> along(const Place& place, const Point<3>& vector) const;

 private:
  int axis_, first_, second_;  ///< right-handed: x, y, z or a cyclic permutation
  Point<3> center_;
  double lowest_;         ///< lower end of the box along the axis [m]
  double width_, depth_;  ///< size of a bin along R and z [m]
  std::vector<double> radii_, heights_, cells_;
};

}  // namespace washfsi
