// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "washfsi/cloth/cloths.hpp"
#include "washfsi/placement/flat_cloth.hpp"

namespace washfsi {

/// Uniform numbers in [0, 1), the same with every standard library.
class Uniform {
 public:
  explicit Uniform(PetscInt seed) : engine_(static_cast<std::uint64_t>(seed)) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

/// Dimensions of the shapes that a cloth may start with (-..._shape).
template <int Dim>
struct ShapeOptions {
  double semi_axes[2] = {0.1, 0.05};  ///< semi-axes of an ellipse, along and across the cloth's direction [m]
  PetscInt mode = 1;                  ///< number of a bending mode of a free cloth, in the order of frequency
  double amplitude = 0.01;            ///< largest deflection of the mode [m]
  double crumpling = 0.5;             ///< largest turn from edge to edge of a crumpled cloth [rad]

  static ShapeOptions from_options(Options& options, const std::string& group);
};

/// Gives the markers of one flat cloth the shape of its group:
///   flat      as it is
///   ellipse   (in the plane) round its middle, closed, equally spaced; stretched if that is longer than the cloth
///   mode      displaced along the normal by a bending mode of a free beam or plate
///   bar_mode  displaced along s by the first longitudinal mode of a free bar
///   crumpled  unstretched, each edge along s turned from the last by a random angle, its centre in the middle
template <int Dim>
Points<Dim> shaped_cloth(const ClothGroup<Dim>& group, const ShapeOptions<Dim>& shape, const FlatCloth<Dim>& flat,
                         Uniform& uniform);

extern template struct ShapeOptions<2>;
extern template struct ShapeOptions<3>;

}  // namespace washfsi
