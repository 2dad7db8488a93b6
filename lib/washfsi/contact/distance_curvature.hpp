// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/LU>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/contact/facing.hpp"

namespace washfsi {

/// The second derivative of the distance of two parts that face each other. With the way r = sum of s_i X_i between the
/// nearest points, whose places on their facets have the coordinates l_k, the half square g = r^2/2 has
///   d2g/dX_i dX_j = s_i s_j I - sum over k, m of  a_ik (t_k . t_m)^-1 a_jm^T,
///   t_k = dr/dl_k,  a_ik = ds_i/dl_k r + s_i t_k
/// since the nearest points move as the markers do, and the distance d = sqrt(2 g).
template <int Dim>
class DistanceCurvature {
 public:
  /// `all` are the places of the markers. `first_slides`: the first point too is the nearest one of a facet, not fixed
  /// in it.
  DistanceCurvature(const Facing<Dim>& facing, const Points<Dim>& all, bool first_slides) : facing_(facing) {
    if (first_slides) add_coordinates(all, 1);
    add_coordinates(all, -1);
    if (count_ == 0) return;
    const auto products = (ways_.leftCols(count_).transpose() * ways_.leftCols(count_)).eval();
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(products);
    is_regular_ = lu.isInvertible();
    if (is_regular_) inverse_.topLeftCorner(count_, count_) = lu.inverse();
  }

  /// Whether the nearest points are unique: not of parallel edges.
  bool is_regular() const { return is_regular_; }

  /// d2d/dX_i dX_j [1/m]
  StiffnessBlock<Dim> block(std::size_t i, std::size_t j) const {
    StiffnessBlock<Dim> block = StiffnessBlock<Dim>::Identity() - facing_.normal * facing_.normal.transpose();
    block *= facing_.shares[i] * facing_.shares[j];
    for (int k = 0; k < count_; ++k)
      for (int m = 0; m < count_; ++m) block -= inverse_(k, m) * change(i, k) * change(j, m).transpose();
    return block / facing_.distance;
  }

 private:
  static constexpr int most = 2;  // coordinates

  // Adds one coordinate for each marker with a share of this sign except the first.
  void add_coordinates(const Points<Dim>& all, double sign) {
    const auto is_of_part = [&](std::size_t i) { return sign * facing_.shares[i] > 0; };
    std::size_t first = 0;
    while (first < facing_.count && !is_of_part(first)) ++first;
    for (std::size_t i = first + 1; i < facing_.count && count_ < most; ++i) {
      if (!is_of_part(i)) continue;
      ends_[static_cast<std::size_t>(count_)] = {first, i};
      ways_.col(count_++) = all[facing_.markers[first]] - all[facing_.markers[i]];
    }
  }
  // a_ik
  Point<Dim> change(std::size_t i, int k) const {
    const auto& [first, other] = ends_[static_cast<std::size_t>(k)];
    const double rate = i == first ? 1 : i == other ? -1 : 0;
    return rate * facing_.distance * facing_.normal + facing_.shares[i] * ways_.col(k);
  }

  const Facing<Dim>& facing_;
  int count_ = 0;
  bool is_regular_ = true;
  std::array<std::pair<std::size_t, std::size_t>, most> ends_{};
  Eigen::Matrix<double, Dim, most> ways_ = Eigen::Matrix<double, Dim, most>::Zero();
  Eigen::Matrix<double, most, most> inverse_ = Eigen::Matrix<double, most, most>::Zero();
};

}  // namespace washfsi
