// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// Linear interpolation of value(index) given on points at lower + (i + offset_d) h_d.
template <int Dim, class Value>
double interpolate_linearly(const Grid<Dim>& grid, const Point<Dim>& place, const Point<Dim>& offset,
                            const Value& value) {
  Index<Dim> base;
  Point<Dim> fraction;
  for (int d = 0; d < Dim; ++d) {
    const double coordinate = (place[d] - grid.lower()[d]) / grid.spacing()[d] - offset[d];
    const double floor = std::floor(coordinate);
    base[d] = static_cast<PetscInt>(floor);
    fraction[d] = coordinate - floor;
  }
  double sum = 0;
  for (unsigned corner = 0; corner < (1U << Dim); ++corner) {
    Index<Dim> index = base;
    double weight = 1;
    for (int d = 0; d < Dim; ++d) {
      const bool upper = (corner >> d) & 1U;
      if (upper) ++index[d];
      weight *= upper ? fraction[d] : 1 - fraction[d];
    }
    if (weight != 0) sum += weight * value(index);
  }
  return sum;
}

/// Velocity component c at a place, linearly between the faces round it, which `u` contains, ghosts included.
template <int Dim>
double interpolate_face(const Grid<Dim>& grid, const ConstFaceView<Dim>& u, const Point<Dim>& place, int c) {
  Point<Dim> offset = Point<Dim>::Constant(0.5);
  offset[c] = 0;
  return interpolate_linearly<Dim>(grid, place, offset, [&](const Index<Dim>& index) { return u(index, c); });
}

}  // namespace washfsi
