// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/shapes/primitives.hpp"

#include <algorithm>

#include "washfsi/geometry/nearest.hpp"

namespace washfsi {

template <int Dim>
double Cuboid<Dim>::distance(const Point<Dim>& place) const {
  const Point<Dim> beyond = place.cwiseAbs() - half_;
  return beyond.cwiseMax(0.0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

// The extent is finite only if the normal lies along an axis.
template <int Dim>
Extent<Dim> HalfSpace<Dim>::extent() const {
  Extent<Dim> result = Extent<Dim>::infinite();
  for (int d = 0; d < Dim; ++d) {
    if (normal_[d] == 1) result.bounds.upper[d] = 0;
    if (normal_[d] == -1) result.bounds.lower[d] = 0;
  }
  return result;
}

template <int Dim>
double Capsule<Dim>::distance(const Point<Dim>& place) const {
  return way_from_segment<Dim>(from_, axis_, place).norm() - radius_;
}

template class Cuboid<2>;
template class Cuboid<3>;
template class HalfSpace<2>;
template class HalfSpace<3>;
template class Capsule<2>;
template class Capsule<3>;

}  // namespace washfsi
