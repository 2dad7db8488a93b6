// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/immersed_boundary/delta.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// How a wall of markers acts on water, which sees them smeared by the kernel. Let y and y' be distributed as the
/// kernel along the normal n of the wall, in cells. Water sheared on one side of a sheet of markers slips as if the
/// wall lay y_m = <|y - y'|>/2 before them. Sheared alike on both sides of two sheets at a distance 2d, it slips as if
/// a plate were there, of half thickness
///   (<|y - y'|> + <|2d + y - y'|>)/2,
/// which is <|y - y'|> for a single sheet. The second difference of the grid lowers the mean <|y - y'|> by
/// 1/6 sum_d n_d^4 times the density of y - y' at 0.
class KernelMoments {
 public:
  KernelMoments(DeltaKernel kernel, double width);

  double width() const { return width_; }  ///< half width of the kernel [cells]
  /// The density of y - y': how much two kernels at this distance overlap [1/cells].
  double overlap(double shift) const;
  /// var phi, the variance <y^2> of the kernel [cells^2].
  double variance() const { return variance_; }
  /// <|y - y'|> on a grid: how far before its faces and beyond its edges a sheet of markers acts [cells].
  double sheet_reach() const { return sheet_reach_; }
  /// The same for a sheet with this unit normal on cells of this spacing [m], as a length [m]. Water that the sheet
  /// drags along itself on both sides alike is interpolated at the sheet as if it were that far from it.
  template <int Dim>
  double sheet_reach(const Point<Dim>& normal, const Point<Dim>& spacing) const {
    const Point<Dim> across = normal.cwiseProduct(spacing);
    const double width = across.norm();
    if (width == 0) return 0;
    const double fourth = normal.cwiseProduct(across).squaredNorm();  // sum n_d^4 h_d^2
    return mean_distance_ * width - overlap(0) / 6 * fourth / width;
  }
  /// How far behind the surface of a part of this half thickness its markers belong; all in cells. Parts thinner than
  /// a sheet of markers acts get one sheet in their middle.
  double retraction(double half_thickness) const;

 private:
  double mean_difference(double shift) const;
  double acting_half_thickness(double d) const { return 0.5 * (sheet_reach_ + mean_difference(2 * d)); }

  double width_, spacing_, variance_ = 0, mean_distance_ = 0, sheet_reach_ = 0;
  std::vector<double> weights_;   ///< distribution of y - y' at equal spacing, from -2 width on
  std::vector<double> by_depth_;  ///< retraction at equal steps of half thickness
};

}  // namespace washfsi
