// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/drum_walls.hpp"

#include <algorithm>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

// Whether a body covers a pair of opposite sides of the box completely at the start, as a drum does.
template <int Dim>
bool fills_the_sides(const Body<Dim>& body, const GridShape<Dim>& shape, int axis) {
  const Point<Dim> extent = shape.upper - shape.lower;
  Box<Dim> side{{}, shape.cells};
  side.upper[axis] = 2;  // both ends
  bool filled = true;
  for_each<Dim>(side, [&](const Index<Dim>& face) {
    Point<Dim> place;
    for (int e = 0; e < Dim; ++e) {
      const auto d = e;
      const double cells = e == axis ? 1 : static_cast<double>(shape.cells[e]);
      const double position = e == axis ? static_cast<double>(face[e]) : static_cast<double>(face[e]) + 0.5;
      place[d] = shape.lower[d] + extent[d] * position / cells;
    }
    filled = filled && body.distance(place, 0) <= 0;
  });
  return filled;
}

// The axes along which a motion may carry material through the sides of the box; turning is about z.
template <int Dim>
std::vector<int> axes_moved_along(const RigidMotion<Dim>& motion) {
  std::vector<int> axes{0, 1};
  if (Dim == 3 && (motion.table || motion.translation[Dim - 1] != 0)) axes.push_back(2);
  return axes;
}

// A moving side behind a body at rest would be hidden, but still drag what lies within the reach of its ghosts.
template <int Dim>
void refuse_hidden_motion(const Body<Dim>& body, const typename Boundary<Dim>::Sides& sides,
                          const GridShape<Dim>& shape) {
  for (int axis = 0; axis < Dim; ++axis) {
    const bool moves = !sides[axis][0].velocity.isZero(0) || !sides[axis][1].velocity.isZero(0);
    if (moves && sides[axis][0].kind == BoundaryKind::wall && fills_the_sides(body, shape, axis))
      throw InputError("-bc_" + std::string(1, "xyz"[axis]) + "_..._velocity: this wall lies behind the body " +
                       body.name + ", which fills the box up to it");
  }
}

}  // namespace

template <int Dim>
typename Boundary<Dim>::Sides sides_with_drum(typename Boundary<Dim>::Sides sides, const GridShape<Dim>& shape,
                                              const std::vector<Body<Dim>>& bodies) {
  const auto periodic = [&](int axis) { return sides[axis][0].kind == BoundaryKind::periodic; };
  for (const auto& body : bodies) {
    if (body.motion.at_rest()) {
      refuse_hidden_motion(body, sides, shape);
      continue;
    }
    const std::vector<int> axes = axes_moved_along(body.motion);
    const auto passes = [&](int axis) { return periodic(axis) || fills_the_sides(body, shape, axis); };
    if (!std::all_of(axes.begin(), axes.end(), passes)) continue;
    for (const int axis : axes)
      for (auto& side : sides[axis]) {
        if (side.kind != BoundaryKind::wall) continue;
        if (!side.velocity.isZero(0))
          throw InputError("-bc_" + std::string(1, "xyz"[axis]) + "_..._velocity: this wall moves with the body " +
                           body.name + ", which fills the box up to it");
        side.motion = [motion = body.motion](const Point<Dim>& place, double time) {
          return motion.velocity(place, time);
        };
      }
  }
  return sides;
}

template Boundary<2>::Sides sides_with_drum<2>(Boundary<2>::Sides, const GridShape<2>&, const std::vector<Body<2>>&);
template Boundary<3>::Sides sides_with_drum<3>(Boundary<3>::Sides, const GridShape<3>&, const std::vector<Body<3>>&);

}  // namespace washfsi
