// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/body/motion.hpp"
#include "washfsi/body/shape.hpp"

namespace washfsi {

/// How bodies hold the water: by the sharp mask alone (4.2-6), or with viscous stencils that end at the walls as well.
enum class BodyMethod { mapping, cut_stencil };

/// A named solid: a shape that moves rigidly.
template <int Dim>
struct Body {
  std::string name;
  ShapePtr<Dim> shape;
  RigidMotion<Dim> motion;

  /// Signed distance Phi [m]: negative in the solid.
  double distance(const Point<Dim>& place, double time) const {
    return shape->distance(motion.in_body_frame(place, time));
  }

  /// `sample_spacing` [m]: default for shapes that are kept on a lattice. Errors: InputError. Collective.
  static Body from_options(Options& options, const std::string& name, double sample_spacing);
};

/// -body_method.
BodyMethod body_method_from_options(Options& options);

/// All bodies named by -bodies, in a grid whose smallest cell is `cell` wide [m]. Errors: InputError. Collective.
template <int Dim>
std::vector<Body<Dim>> bodies_from_options(Options& options, double cell);

/// Distance to the nearest body [m]; very large without bodies.
template <int Dim>
double nearest_distance(const std::vector<Body<Dim>>& bodies, const Point<Dim>& place, double time);

}  // namespace washfsi
