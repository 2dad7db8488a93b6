// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>

#include "washfsi/support/petsc.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Solves (1 + s K M) y = r, of the stiffness K and the mobility M, for groups of near markers, each as if the others
/// did not move. Unlike the row sums of M they know that many sheets in one cell move one water: together easily,
/// against each other hardly at all. What reaches farther is left to others.
template <int Dim>
class MarkerBlocks {
 public:
  /// For this rank's markers at these places. K and M are AIJ matrices with a row for each coordinate of each marker.
  /// No communication.
  void factorise(const Points<Dim>& places, Mat stiffness, Mat mobility, double s);
  /// No communication.
  Points<Dim> solve(const Points<Dim>& right) const;

 private:
  using Markers = std::vector<std::size_t>;
  struct Block {
    Markers markers;
    Eigen::PartialPivLU<Eigen::MatrixXd> factors;
  };
  static void split(const Points<Dim>& places, Markers markers, std::vector<Markers>& groups);

  std::vector<Block> blocks_;
};

extern template class MarkerBlocks<2>;
extern template class MarkerBlocks<3>;

}  // namespace washfsi
