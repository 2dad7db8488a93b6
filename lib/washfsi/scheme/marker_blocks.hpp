// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <Eigen/LU>

#include "washfsi/support/petsc.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Solves (1 + s M K) v = r, of the stiffness K and the mobility M, for groups of near markers, each as if the others
/// did not move. Unlike the row sums of M they know that many sheets in one cell move one water: together easily,
/// against each other hardly at all. What reaches farther is left to others.
template <int Dim>
class MarkerBlocks {
 public:
  using Markers = std::vector<std::size_t>;
  /// M between the coordinates of some of this rank's markers.
  using MobilityBlock = std::function<Eigen::MatrixXd(const Markers&)>;
  /// For this rank's markers at these places. K is an AIJ matrix with a row for each coordinate of each marker. No
  /// communication.
  void factorise(const Points<Dim>& places, Mat stiffness, const MobilityBlock& mobility, double s);
  /// No communication.
  Points<Dim> solve(const Points<Dim>& right) const;

 private:
  struct Block {
    Markers markers;
    Eigen::PartialPivLU<Eigen::MatrixXf> factors;  ///< that is enough to precondition
  };
  static void split(const Points<Dim>& places, Markers markers, std::vector<Markers>& groups);

  std::vector<Block> blocks_;
};

extern template class MarkerBlocks<2>;
extern template class MarkerBlocks<3>;

}  // namespace washfsi
