// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/point.hpp"

namespace washfsi {

/// The place of a flat cloth, from edge to edge: a segment in the plane, a rectangle in space.
template <int Dim>
struct FlatCloth {
  static constexpr int directions = Dim - 1;
  using Coordinates = Eigen::Matrix<double, directions, 1>;

  Eigen::Matrix<double, Dim, Dim> axes = Eigen::Matrix<double, Dim, Dim>::Identity();  ///< along s, (along r,) normal
  Point<Dim> middle = Point<Dim>::Zero();
  Coordinates half = Coordinates::Zero();  ///< half lengths [m]

  Point<Dim> along() const { return axes.col(0); }
  Point<Dim> normal() const { return axes.col(Dim - 1); }
  /// A place at distances from the middle along s (and r), in half lengths.
  Point<Dim> at(const Coordinates& place) const {
    return middle + axes.template leftCols<directions>() * half.cwiseProduct(place);
  }
};

/// Least distance of two flat cloths; 0 if they cross.
template <int Dim>
double distance(const FlatCloth<Dim>& a, const FlatCloth<Dim>& b);

}  // namespace washfsi
