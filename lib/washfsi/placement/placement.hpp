// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/motion/body.hpp"
#include "washfsi/placement/cloth_shape.hpp"

namespace washfsi {

/// The rule by which the cloths of a group are placed, see `place_cloths`.
enum class PlacementRule { line, stack, radial, random };
const ChoiceNames<PlacementRule>& names_of(PlacementRule);

/// Where the cloths of one group start. All lengths in metres.
template <int Dim>
struct PlacementOptions {
  PlacementRule rule = PlacementRule::line;
  Point<Dim> center =
      Point<Dim>::Zero();  ///< centre of the first cloth (line, stack), of the fan (radial), of the disc (random)
  Point<Dim> direction = Point<Dim>::UnitX();  ///< direction of the cloths' s (line, stack)
  Point<Dim> across = Point<Dim>::UnitY();     ///< direction of their r, in space (line, stack)
  double distance = 0.02;                      ///< gap of neighbours (line: along the cloth; stack: along its normal)
  double inner_radius = 0.1;                   ///< radius where the cloths begin (radial)
  double shift = 0;                            ///< largest shift of each cloth along each axis (radial)
  double tilt = 0;                             ///< largest tilt of each cloth about each axis [rad] (radial)
  double radius = 0.3;                         ///< radius of the disc that contains the cloths (random)
  double height = 0.2;                         ///< height of that disc, in space (random)
  double clearance = 0.01;                     ///< least distance from bodies and other cloths (random)
  PetscInt seed = 1;
  ShapeOptions<Dim> shape;  ///< shape of the cloth, whatever its place

  static PlacementOptions from_options(Options& options, const std::string& group);
};

/// Marker positions of all cloths in marker order, flat or with the shape of their group. Every rank computes all of
/// them.
///   line    cloths end to end, `distance` apart, centres along `direction`
///   stack   parallel cloths, `distance` apart along their normal
///   radial  cloths standing as fins round `center` with s outwards, in space r upwards: evenly spread in angle, from
///           `inner_radius` on; each shifted and tilted by a uniformly random part of `shift` and `tilt`
///   random  middle and direction drawn uniformly in a disc (about z) until a cloth, at every point, is farther than
///           `clearance` from every body and from every cloth placed before (of other groups too)
/// Random numbers are seeded by `seed`.
/// `space` is the box. Along its periodic axes a cloth may reach over the sides, and images of cloths and bodies count.
/// Errors: InputError if a random cloth finds no place, or if any cloth starts in a body or outside the box.
template <int Dim>
Points<Dim> place_cloths(const Cloths<Dim>& cloths, const std::vector<PlacementOptions<Dim>>& placements,
                         const std::vector<Body<Dim>>& bodies, const PeriodicSpace<Dim>& space);

}  // namespace washfsi
