// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace washfsi {

/// A place, velocity or force in the plane or in space, in SI units.
template <int Dim>
using Point = Eigen::Matrix<double, Dim, 1>;

/// A linear map of such points.
template <int Dim>
using Block = Eigen::Matrix<double, Dim, Dim>;

/// One value per marker.
template <int Dim>
using Points = std::vector<Point<Dim>>;

// Marker by marker, so that formulas over all markers read as such: x + dt * v.

template <int Dim>
Points<Dim>& operator+=(Points<Dim>& a, const Points<Dim>& b) {
  for (std::size_t m = 0; m < a.size(); ++m) a[m] += b[m];
  return a;
}

template <int Dim>
Points<Dim> operator+(Points<Dim> a, const Points<Dim>& b) {
  return std::move(a += b);
}

template <int Dim>
Points<Dim> operator-(Points<Dim> a, const Points<Dim>& b) {
  for (std::size_t m = 0; m < a.size(); ++m) a[m] -= b[m];
  return a;
}

template <int Dim>
Points<Dim> operator*(double factor, Points<Dim> a) {
  for (auto& value : a) value *= factor;
  return a;
}

/// A vector turned by a right angle about z.
template <int Dim>
Point<Dim> turned_left(const Point<Dim>& v) {
  Point<Dim> result = Point<Dim>::Zero();
  result.template head<2>() << -v[1], v[0];
  return result;
}

/// Components of a rotation vector: 1 in the plane (about z), 3 in space.
template <int Dim>
inline constexpr int rotation_components = Dim == 2 ? 1 : 3;

/// A torque or angular velocity [N m, rad/s].
template <int Dim>
using Rotation = Eigen::Matrix<double, rotation_components<Dim>, 1>;

/// arm x force: the torque of a force about the foot of its arm.
template <int Dim>
Rotation<Dim> cross(const Point<Dim>& arm, const Point<Dim>& force) {
  if constexpr (Dim == 2)
    return Rotation<2>(arm[0] * force[1] - arm[1] * force[0]);
  else
    return arm.cross(force);
}

}  // namespace washfsi
