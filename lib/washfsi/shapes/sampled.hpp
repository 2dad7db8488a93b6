// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mpi.h>

#include "washfsi/grid/index.hpp"
#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// Equally spaced points of a box.
template <int Dim>
struct Lattice {
  Point<Dim> lower = Point<Dim>::Zero();  ///< first point [m]
  double spacing = 1;                     ///< [m]
  Index<Dim> count{};                     ///< points in each direction, at least 2

  /// Returns a lattice that covers a box and `margin` [m] around it.
  static Lattice around(const Point<Dim>& lower, const Point<Dim>& upper, double margin, double spacing);

  double size() const;                        ///< number of points; may be more than fit anywhere
  static constexpr double most_points = 5e7;  ///< most points of a lattice, all of which each rank stores: 400 MB
  Box<Dim> points() const { return {{}, count}; }
  Point<Dim> place(const Index<Dim>& point) const;
};

/// A solid whose distance is sampled on a lattice that contains it. Between the points the interpolation is
/// multilinear, with an error of at most spacing^2/8 times the sum of the distance's second derivatives, or about
/// spacing/2 times the jump of its slope where it has a kink. Beyond the lattice it is a lower bound: the solid is on
/// the other side of the plane through the nearest place of the lattice's box, so it is at least the hypotenuse away.
template <int Dim>
class Sampled : public Shape<Dim> {
 public:
  /// One value per point, x first.
  Sampled(const Lattice<Dim>& lattice, std::vector<double> values);
  double distance(const Point<Dim>& place) const override;
  Extent<Dim> extent() const override { return {{lattice_.lower, upper_}}; }

  /// Samples a shape; each rank computes a part, and all get the whole. Collective.
  static std::unique_ptr<Sampled> of(MPI_Comm comm, const Shape<Dim>& shape, const Lattice<Dim>& lattice);

 private:
  double interpolate(const Point<Dim>& place) const;

  Lattice<Dim> lattice_;
  Point<Dim> upper_;
  Index<Dim> stride_{};
  std::vector<double> values_;
};

extern template struct Lattice<2>;
extern template struct Lattice<3>;
extern template class Sampled<2>;
extern template class Sampled<3>;

}  // namespace washfsi
