// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/trust/resting_sides.hpp"

#include <algorithm>
#include <string>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/format_text.hpp"

namespace washfsi {

namespace {

template <int Dim>
bool rests(const Side<Dim>& side) {
  return side.kind == BoundaryKind::wall && !side.motion && side.velocity.isZero(0);
}

// Whether a body covers the corners of a side, so that its opening lies within. An agitator on the floor does not.
template <int Dim>
bool surrounds(const PosedBodies<Dim>& posed, std::size_t body, const Grid<Dim>& grid, int axis, End end) {
  bool has_edge = false;
  for (int d = 0; d < Dim; ++d) has_edge = has_edge || (d != axis && !grid.periodic(d));
  Box<Dim> corners{};
  corners.upper.fill(2);
  corners.upper[axis] = 1;
  bool held = true;
  for_each<Dim>(corners, [&](const Index<Dim>& corner) {
    Index<Dim> cell;
    for (int d = 0; d < Dim; ++d) {
      const bool is_last = d == axis ? end == End::upper : corner[d] == 1;
      cell[d] = is_last ? grid.cells()[d] - 1 : 0;
    }
    held = held && posed.distance(body, grid.cell_center(cell)) <= 0;
  });
  return has_edge && held;
}

/// The part of a side that the water touches.
struct OpenPart {
  double cells = 0;
  double reach = 0;  ///< largest distance from a vertical axis [m]
};

template <int Dim>
OpenPart open_part(const PosedBodies<Dim>& posed, std::size_t body, const Grid<Dim>& grid, int axis, End end) {
  OpenPart open;
  for_each<Dim>(grid.cells_beside(axis, end), [&](const Index<Dim>& cell) {
    const Point<Dim> place = grid.cell_center(cell);
    if (posed.holder(place) < posed.size()) return;
    ++open.cells;
    open.reach = std::max(open.reach, posed[body].arm(place).template head<2>().norm());
  });
  return {ordered_sum(grid.comm(), open.cells), largest(grid.comm(), open.reach)};
}

template <int Dim>
Finding finding_of(const Body<Dim>& body, const OpenPart& open, int axis, End end) {
  const double speed = body.motion.largest_speed(open.reach);
  const std::string side = std::string("bc_") + "xyz"[axis] + (end == End::lower ? "_lower" : "_upper");
  return at_most(body.name + " over " + side, speed, {0},
                 format_text("up to %.3g m/s past %.0f cells of a wall that rests", speed, open.cells),
                 "it holds back water that the body's own end would take along; let " + body.name +
                     " end two cells from it, or -" + side + " slip");
}

}  // namespace

template <int Dim>
Findings resting_side_findings(const Model<Dim>& model, double time) {
  const PosedBodies<Dim> posed(model.body_list, time);
  Findings findings;
  for (std::size_t b = 0; b < model.body_list.size(); ++b) {
    const RigidMotion<Dim>& motion = model.body_list[b].motion;
    for (int axis = 0; axis < Dim && !motion.at_rest(); ++axis)
      for (const End end : {End::lower, End::upper}) {
        if (!rests(model.boundary.side(axis, end)) || !surrounds(posed, b, model.grid, axis, end)) continue;
        const OpenPart open = open_part(posed, b, model.grid, axis, end);
        if (open.cells > 0) findings.push_back(finding_of(model.body_list[b], open, axis, end));
      }
  }
  return findings;
}

template Findings resting_side_findings<2>(const Model<2>&, double);
template Findings resting_side_findings<3>(const Model<3>&, double);

}  // namespace washfsi
