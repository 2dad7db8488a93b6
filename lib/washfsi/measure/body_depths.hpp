// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "washfsi/grid/grid.hpp"
#include "washfsi/measure/cloth_mesh.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// The depths to which the faces of cloths, and the edges of fibres in space, reach into bodies, between markers too.
/// It checks the contact forces independently, from the markers and the bodies' signed distances only. A face is
/// halved, and its halves again, as long as a part of it may reach deeper than what was found: a signed distance
/// changes by no more than the distance between places. Depths of more than a thousandth of a face's size are found, to
/// within a tenth of that size.
template <int Dim>
class BodyDepths {
 public:
  /// All must outlive it.
  BodyDepths(const Cloths<Dim>& cloths, const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies);

  /// Computes the depths for these places of this rank's markers, unless they are those of the last call. Collective.
  void look(const Points<Dim>& positions, double time);
  /// The number of faces that reach into a body.
  double total() const { return total_; }
  /// The depth of the deepest face of each group [m]; 0 if none is inside.
  const std::vector<double>& of_groups() const { return of_groups_; }
  /// Describes the deepest face; empty if there is none.
  const std::string& example() const { return example_; }

 private:
  struct Deepest {
    double depth = 0;  ///< [m]
    std::size_t piece = 0, body = 0;
    Point<Dim> place = Point<Dim>::Zero();
  };
  template <std::size_t Count>
  void add(const std::array<Point<Dim>, Count>& corners, std::size_t piece, const PosedBodies<Dim>& posed);
  void share(const Deepest& deepest);

  const Cloths<Dim>& cloths_;
  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  ClothMesh<Dim> mesh_;
  Points<Dim> seen_;  ///< places and time of the last `look`
  double time_ = 0;
  double total_ = 0;
  std::vector<double> of_groups_;
  Deepest deepest_;
  std::string example_;
};

extern template class BodyDepths<2>;
extern template class BodyDepths<3>;

}  // namespace washfsi
