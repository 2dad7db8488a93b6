// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/marker_layout/even_spread.hpp"
#include "washfsi/marker_layout/marker_layout.hpp"
#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// The plane across an axis in which a shape that is thin somewhere is its own mirror image; of several, that across
/// the axis along which it is thinnest. Its markers are laid on one side and mirrored, so that what flows alike past
/// both sides loads them alike: few markers hold thin parts, and where they lie matters. Solids have none: markers on
/// faces a few cells apart hold the water best where they do not lie opposite each other.
template <int Dim>
class Mirror {
 public:
  /// All ranks have all candidates, which are places of all of what is to be laid. Collective.
  Mirror(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout, const std::vector<Candidate<Dim>>& candidates);

  /// Those on the upper side, and in the plane; all without a plane.
  std::vector<Candidate<Dim>> half(const std::vector<Candidate<Dim>>& candidates) const;
  /// With the images of all patches; of one that has markers in the plane, with the images of the others in it.
  MarkerPatches<Dim> whole(const MarkerPatches<Dim>& half) const;

 private:
  bool is_plane(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout,
                const std::vector<Candidate<Dim>>& candidates) const;
  double above(const Point<Dim>& place) const { return place[axis_] - middle_; }
  Point<Dim> image(Point<Dim> place) const {
    place[axis_] = middle_ - above(place);
    return place;
  }

  int axis_ = 0;
  double middle_ = 0;  ///< where the plane is on the axis [m]
  double near_ = 0;    ///< to it is in it [m]
  bool is_there_ = false;
};

extern template class Mirror<2>;
extern template class Mirror<3>;

}  // namespace washfsi
