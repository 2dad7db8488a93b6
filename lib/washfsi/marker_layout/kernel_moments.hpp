// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/immersed_boundary/delta.hpp"

namespace washfsi {

/// How a wall of markers acts on water, which sees them smeared by the delta. Let s and t be distributed as the delta
/// along the wall's normal, in cells. Water sheared on one side of a sheet of markers slips as if the wall lay
/// <|s - t|>/2 before them; sheared alike on both sides of two sheets 2d apart, as if a plate of half thickness
///   b(d) = (<|s - t|> + <|2d + s - t|>)/2
/// were there: <|s - t|> for a single sheet. On a grid the water's second difference takes the bend of |s - t| as wider
/// than it is, which is a sixth of the overlap at it nearer, times the sum of the normal's fourth powers.
class KernelMoments {
 public:
  KernelMoments(DeltaKernel kernel, double width);

  double width() const { return width_; }  ///< half width of the delta [cells]
  /// The density of s - t: how much two deltas this far apart overlap [1/cells].
  double overlap(double shift) const;
  /// <s^2> [cells^2].
  double variance() const { return variance_; }
  /// <|s - t|> on a grid: how far before its faces and beyond its edges a sheet of markers acts [cells].
  double sheet_reach() const { return sheet_reach_; }
  /// How far behind the surface of a part of this half thickness its markers belong; all in cells. Parts thinner than
  /// a sheet of markers acts get one sheet in their middle.
  double retraction(double half_thickness) const;

 private:
  double mean_difference(double shift) const;
  double acting_half_thickness(double d) const { return 0.5 * (sheet_reach_ + mean_difference(2 * d)); }

  double width_, spacing_, variance_ = 0, sheet_reach_ = 0;
  std::vector<double> weights_;   ///< distribution of s - t at equal spacing, from -2 width on
  std::vector<double> by_depth_;  ///< retraction at equal steps of half thickness
};

}  // namespace washfsi
