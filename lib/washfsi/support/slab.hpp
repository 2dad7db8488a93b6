// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <hdf5.h>

#include "washfsi/support/point.hpp"

namespace washfsi {

/// The part of a dataset that this rank has: slowest index first.
struct Slab {
  std::vector<hsize_t> shape;   ///< shape of the whole dataset
  std::vector<hsize_t> offset;  ///< offset of this rank's part
  std::vector<hsize_t> count;   ///< shape of this rank's part; a zero means none
};

/// A slab with a last dimension for so many components; without one for a single component.
inline Slab with_components(Slab slab, int components) {
  if (components == 1) return slab;
  slab.shape.push_back(static_cast<hsize_t>(components));
  slab.offset.push_back(0);
  slab.count.push_back(static_cast<hsize_t>(components));
  return slab;
}

/// The rows from `begin` to `end` of `total`, with `components` each.
inline Slab row_slab(std::size_t total, std::size_t begin, std::size_t end, int components) {
  return with_components({{total}, {begin}, {end - begin}}, components);
}

/// Flat values of points, padded with zeros to `components` each.
template <int Dim>
std::vector<double> flattened(const Points<Dim>& points, int components = Dim) {
  std::vector<double> values;
  values.reserve(points.size() * static_cast<std::size_t>(components));
  for (const auto& point : points)
    for (int c = 0; c < components; ++c) values.push_back(c < Dim ? point[c] : 0.0);
  return values;
}

/// The inverse, without padding.
template <int Dim>
Points<Dim> as_points(const std::vector<double>& values) {
  Points<Dim> points(values.size() / Dim);
  for (std::size_t m = 0; m < points.size(); ++m) points[m] = Point<Dim>(&values[m * Dim]);
  return points;
}

}  // namespace washfsi
