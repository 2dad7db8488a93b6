// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/marker_layout/even_spread.hpp"
#include "washfsi/marker_layout/marker_layout.hpp"
#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// The plane across an axis in which a shape that is thin somewhere is its own mirror image; of several, that across
/// the axis along which it is thinnest. Its markers are laid on one side and mirrored, so that what flows alike past
/// both sides loads them alike: thin parts have few markers, and where they lie matters. Solids have none: markers on
/// faces a few cells apart enforce no slip best where they do not lie opposite each other.
template <int Dim>
class Mirror {
 public:
  /// All ranks have all candidates, which cover all of the surface to be laid out. Collective.
  Mirror(const Shape<Dim>& shape, const MarkerLayout<Dim>& layout, const std::vector<Candidate<Dim>>& candidates);

  /// The candidates on the upper side and in the plane; all of them without a plane.
  std::vector<Candidate<Dim>> half(const std::vector<Candidate<Dim>>& candidates) const;
  /// Adds the images of all patches; a patch with markers in the plane gets the images of its other markers itself.
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
  double near_ = 0;    ///< distance up to which places count as in the plane [m]
  bool is_there_ = false;
};

extern template class Mirror<2>;
extern template class Mirror<3>;

}  // namespace washfsi
