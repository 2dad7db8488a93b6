// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Uniform numbers in [0, 1), the same with every standard library.
class Uniform {
 public:
  explicit Uniform(PetscInt seed) : engine_(static_cast<std::uint64_t>(seed)) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

/// A straight cloth: its whole length, from end to end.
template <int Dim>
struct Segment {
  Point<Dim> from, to;
};

/// A vector turned by a right angle about z.
template <int Dim>
Point<Dim> turned_left(const Point<Dim>& v) {
  Point<Dim> result = Point<Dim>::Zero();
  result.template head<2>() << -v[1], v[0];
  return result;
}

/// Dimensions of the shapes that a cloth may start with (-..._shape).
template <int Dim>
struct ShapeOptions {
  double semi_axes[2] = {0.1, 0.05};  ///< of an ellipse, along and across the cloth's direction [m]
  PetscInt mode = 1;                  ///< of bending of a free cloth
  double amplitude = 0.01;            ///< of the mode, where it is largest [m]
  double crumpling = 0.5;             ///< largest turn from edge to edge of a crumpled cloth [rad]

  static ShapeOptions from_options(Options& options, const std::string& group);
};

/// Markers of one cloth that would lie flat on a segment, with the shape of its group:
///   flat      on the segment
///   ellipse   round its middle, closed, equally spaced along the ellipse; stretched if that is longer than the cloth
///   mode      displaced to the left by a bending mode of a free beam
///   crumpled  unstretched, each edge turned from the last by a random angle, its centre in the segment's middle
template <int Dim>
Points<Dim> shaped_cloth(const ClothGroup<Dim>& group, const ShapeOptions<Dim>& shape, const Segment<Dim>& segment,
                         Uniform& uniform);

extern template struct ShapeOptions<2>;
extern template struct ShapeOptions<3>;

}  // namespace washfsi
