// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/body.hpp"
#include "washfsi/machine/cloth_shape.hpp"

namespace washfsi {

/// Where the cloths of one group start. All lengths in metres.
template <int Dim>
struct PlacementOptions {
  std::string rule = "line";  ///< line | stack | radial | random
  Point<Dim> center =
      Point<Dim>::Zero();  ///< of the first cloth (line, stack), of the fan (radial), of the disc (random)
  Point<Dim> direction = Point<Dim>::UnitX();  ///< of the cloths (line, stack)
  double distance = 0.02;                      ///< between neighbours (line: along the cloth; stack: across it)
  double inner_radius = 0.1;                   ///< where the cloths begin (radial)
  double radius = 0.3;                         ///< of the disc that holds the cloths (random)
  double clearance = 0.01;                     ///< least distance from bodies and other cloths (random)
  PetscInt seed = 1;
  ShapeOptions<Dim> shape;  ///< of the cloth, whatever its place

  static PlacementOptions from_options(Options& options, const std::string& group);
};

/// Marker positions of all cloths in marker order, flat or with the shape of their group. Every rank computes all of
/// them.
///   line    cloths end to end, `distance` apart, centres along `direction`
///   stack   parallel cloths, `distance` apart across `direction`
///   radial  cloths standing as fins round `center`, evenly spread in angle, from `inner_radius` outwards
///   random  centres and angles drawn uniformly in a disc until a cloth, at every point, is farther than `clearance`
///           from every body and from every cloth placed before (of other groups too); seeded by `seed`
/// Errors: InputError if a random cloth finds no place, or if any cloth starts in a body or outside the box.
template <int Dim>
Points<Dim> place_cloths(const Cloths<Dim>& cloths, const std::vector<PlacementOptions<Dim>>& placements,
                         const std::vector<Body<Dim>>& bodies, const Point<Dim>& lower, const Point<Dim>& upper);

}  // namespace washfsi
