// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/marker_layout/surface_markers.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// The markers on the surfaces of all bodies, body by body and patch by patch. Every rank knows the places of all on
/// their bodies; it tracks the markers of its own share of the patches.
template <int Dim>
class BodyMarkers {
 public:
  BodyMarkers(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, MarkerLayout<Dim> layout);

  const std::vector<Body<Dim>>& bodies() const { return bodies_; }
  /// The number of patches; below, the body and the first marker of a patch, whose end is the start of the next.
  std::size_t patches() const { return body_of_.size(); }
  /// This rank's share of the patches.
  PatchRange own() const { return own_; }
  std::size_t body_of(std::size_t patch) const { return body_of_[patch]; }
  std::size_t start(std::size_t patch) const { return starts_[patch]; }
  const Point<Dim>& arm(std::size_t marker) const { return arms_[marker]; }  ///< place in its body's frame [m]
  /// The middle of a patch's part of the surface, in the body's frame.
  Point<Dim> middle(std::size_t patch) const {
    return by_body_[body_of(patch)].middle(patch - firsts_[body_of(patch)]);
  }
  /// Whether a marker of this rank, or any marker of all ranks, lies at an edge or in a thin part, where boundary
  /// layers separate from the body.
  bool is_sharp(std::size_t marker) const { return sharp_[marker - start(own_.begin)]; }
  bool any_is_sharp() const { return any_is_sharp_; }
  /// The markers of one body in its frame; those of all bodies.
  const MarkerPatches<Dim>& of_body(std::size_t body) const { return by_body_[body]; }
  const std::vector<MarkerPatches<Dim>>& by_body() const { return by_body_; }

  /// The region of a body's frame that is ever in the box.
  Bounds<Dim> region(const Body<Dim>& body) const;

  /// The state of one marker at one moment.
  struct State {
    Point<Dim> place, velocity;  ///< [m, m/s]
    bool acts;  ///< false beyond the box, behind another body's surface, and if it moves along a side of the box
    bool is_covered = false;  ///< behind another body's surface
  };
  /// Computes the state of a marker; it and its patch are this rank's.
  State at(const PosedBodies<Dim>& posed, std::size_t patch, std::size_t marker);

 private:
  Bounds<Dim> region_of_one(const Body<Dim>& body) const;
  void follow_own(const MarkerLayout<Dim>& layout);
  bool is_covered(const PosedBodies<Dim>& posed, std::size_t body, std::size_t marker, const Point<Dim>& place);
  bool touches_a_side(const Body<Dim>& body, const Point<Dim>& place) const;

  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  double depth_;  ///< depth of markers behind a flat surface [m]
  std::vector<MarkerPatches<Dim>> by_body_;
  Points<Dim> arms_;  ///< places of all markers in their bodies' frames [m]
  PatchRange own_;
  std::vector<bool> sharp_;  ///< whether each of this rank's markers is sharp
  bool any_is_sharp_ = false;
  std::vector<std::size_t> body_of_;  ///< body of each patch
  std::vector<std::size_t> firsts_;   ///< first patch of each body
  std::vector<std::size_t> starts_;   ///< first marker of each patch, and the end

  /// An earlier place of a marker in another body's frame [m], and the distance of that body there [m].
  struct Seen {
    Point<Dim> place;
    double distance;
  };
  std::vector<Seen> seen_;  ///< one for each marker of this rank and each body
};

extern template class BodyMarkers<2>;
extern template class BodyMarkers<3>;

}  // namespace washfsi
