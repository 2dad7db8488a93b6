// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/mask/wall_loads.hpp"

#include <algorithm>
#include <numbers>

namespace washfsi {

namespace {

// Whether a body covers a place at all times: it rests, or turns about a fixed centre and covers the whole circle. A
// distance never exceeds the true one, so a step along the circle as long as the depth skips nothing.
template <int Dim>
bool holds_always(const Body<Dim>& body, const Point<Dim>& place, double spacing) {
  if (body.distance(place, 0) > 0) return false;
  if (body.motion.at_rest()) return true;
  if (!body.motion.only_turns()) return false;
  const Point<Dim> arm = body.at(0).arm(place);
  const double radius = arm.template head<2>().norm();
  double angle = 0;
  while (angle < 2 * std::numbers::pi) {
    const double depth = -body.shape->distance(Pose<Dim>::at(Point<Dim>::Zero(), angle).in_body_frame(arm));
    if (depth < 0) return false;
    angle += std::max(depth, 0.25 * spacing) / radius;
  }
  return true;
}

}  // namespace

template <int Dim>
std::vector<SideName> exposed_walls(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                    const std::vector<Body<Dim>>& bodies) {
  const double spacing = grid.spacing().minCoeff();
  std::vector<SideName> sides;
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : {End::lower, End::upper}) {
      const BoundaryKind kind = boundary.side(axis, end).kind;
      bool exposed = false;
      for_each<Dim>(grid.cells_beside(axis, end), [&](const Index<Dim>& cell) {
        const Point<Dim> place = grid.cell_center(cell);
        exposed = exposed || std::none_of(bodies.begin(), bodies.end(),
                                          [&](const auto& body) { return holds_always<Dim>(body, place, spacing); });
      });
      exposed = any_rank(grid.comm(), exposed);
      if (exposed && (kind == BoundaryKind::wall || kind == BoundaryKind::slip)) sides.push_back({axis, end});
    }
  return sides;
}

namespace {

/// Force per area on a side beside a cell: the pressure extrapolated linearly to the side, and the friction.
template <int Dim, class Form>
Point<Dim> traction(const ConstFaceView<Dim>& u, const ConstCellView<Dim>& p, const Index<Dim>& cell, SideName side,
                    bool slips, const Form& viscosity, double spacing) {
  const int outwards = side.end == End::upper ? 1 : -1;
  const Index<Dim> inner = shifted<Dim>(cell, side.axis, -outwards), outer = shifted<Dim>(cell, side.axis, outwards);
  Point<Dim> result;
  for (int c = 0; c < Dim; ++c)
    result[c] =
        -(viscosity.scale * viscosity.on_side(cell, c, side.axis, outwards)) * (u(outer, c) - u(cell, c)) / spacing;
  const double pressure = 1.5 * p(cell) - 0.5 * p(inner);
  // along a rigid wall the water does not stretch, so nor does it across; along a slip side it may
  const Index<Dim> next = shifted<Dim>(cell, side.axis, 1);
  const double stretching = slips ? (u(next, side.axis) - u(cell, side.axis)) / spacing : 0;
  result[side.axis] = outwards * (pressure - 2 * viscosity.scale * viscosity.in_cell(cell) * stretching);
  return result;
}

}  // namespace

template <int Dim>
Loads<Dim> wall_loads(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
                      const std::vector<SideName>& sides, Vec local_velocity, Vec pressure, const Viscosity& viscosity,
                      double time) {
  const petsc::LocalVector local_pressure(grid.cell_dm(), pressure);
  const ConstFaceView<Dim> u(grid.face_dm(), local_velocity);
  const ConstCellView<Dim> p(grid.cell_dm(), local_pressure);
  const PosedBodies<Dim> posed(bodies, time);
  const Point<Dim> middle = 0.5 * (grid.lower() + grid.upper());
  Loads<Dim> loads(sides.size());
  with_viscosity<Dim>(grid, viscosity, [&](const auto& mu) {
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const int axis = sides[s].axis;  // names of their own, since a lambda takes them
      const End end = sides[s].end;
      const double spacing = grid.spacing()[axis], area = grid.cell_volume() / spacing;
      const bool slips = boundary.side(axis, end).kind == BoundaryKind::slip;
      for_each<Dim>(grid.cells_beside(axis, end), [&](const Index<Dim>& cell) {
        const Point<Dim> force = area * traction<Dim>(u, p, cell, sides[s], slips, mu, spacing);
        for (int c = 0; c < Dim; ++c) {  // each where its velocity is
          Point<Dim> place = c == axis ? grid.cell_center(cell) : grid.face_center(cell, c);
          const double covered = boundary.covers().share(axis, end, cell, c, time);
          if (covered == 0 && posed.holder(place) < bodies.size()) continue;
          place[axis] = end == End::upper ? grid.upper()[axis] : grid.lower()[axis];
          loads[s].add(place - middle, (1 - covered) * force[c] * Point<Dim>::Unit(c));
        }
      });
    }
  });
  return ordered_sum<Dim>(grid.comm(), loads);
}

template std::vector<SideName> exposed_walls<2>(const Grid<2>&, const Boundary<2>&, const std::vector<Body<2>>&);
template std::vector<SideName> exposed_walls<3>(const Grid<3>&, const Boundary<3>&, const std::vector<Body<3>>&);
template Loads<2> wall_loads<2>(const Grid<2>&, const Boundary<2>&, const std::vector<Body<2>>&,
                                const std::vector<SideName>&, Vec, Vec, const Viscosity&, double);
template Loads<3> wall_loads<3>(const Grid<3>&, const Boundary<3>&, const std::vector<Body<3>>&,
                                const std::vector<SideName>&, Vec, Vec, const Viscosity&, double);

}  // namespace washfsi
