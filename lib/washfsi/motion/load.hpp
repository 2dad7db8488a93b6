// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// Force and torque of water and cloth ON a body or side of the box [N, N m; per unit depth in the plane].
template <int Dim>
struct Load {
  Point<Dim> force = Point<Dim>::Zero();
  Rotation<Dim> torque = Rotation<Dim>::Zero();  ///< torque about the body's centre

  /// Adds a force at the end of an arm from the centre.
  void add(const Point<Dim>& arm, const Point<Dim>& part) {
    force += part;
    torque += cross<Dim>(arm, part);
  }
  /// Adds a force along an axis alone.
  void add(const Point<Dim>& arm, int axis, double part) {
    force[axis] += part;
    if constexpr (Dim == 2) {
      torque[0] += (axis == 0 ? -arm[1] : arm[0]) * part;
    } else {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      torque[next] += arm[last] * part;
      torque[last] -= arm[next] * part;
    }
  }
  Load& operator+=(const Load& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
  friend Load operator*(double factor, const Load& load) { return {factor * load.force, factor * load.torque}; }
};

template <int Dim>
using Loads = std::vector<Load<Dim>>;

/// Sums over the ranks, load by load. Collective.
template <int Dim>
Loads<Dim> ordered_sum(MPI_Comm comm, const Loads<Dim>& mine) {
  constexpr std::size_t width = Dim + rotation_components<Dim>;
  std::vector<double> values;
  for (const Load<Dim>& load : mine) {
    values.insert(values.end(), load.force.data(), load.force.data() + Dim);
    values.insert(values.end(), load.torque.data(), load.torque.data() + rotation_components<Dim>);
  }
  values = ordered_sum(comm, values);
  Loads<Dim> sums(mine.size());
  for (std::size_t b = 0; b < sums.size(); ++b) {
    sums[b].force = Point<Dim>(&values[width * b]);
    sums[b].torque = Eigen::Map<const Rotation<Dim>>(&values[width * b + Dim]);
  }
  return sums;
}

}  // namespace washfsi
