// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

namespace {

template <int Dim>
Box<Dim> ghosted_box(Vec local) {
  DMDALocalInfo info;
  WASH_PETSC(DMDAGetLocalInfo(petsc::dm_of(local), &info));
  const Index<3> start{info.gxs, info.gys, info.gzs}, count{info.gxm, info.gym, info.gzm};
  Box<Dim> box;
  for (int d = 0; d < Dim; ++d) {
    box.lower[d] = start[d];
    box.upper[d] = start[d] + count[d];
  }
  return box;
}

template <int Dim>
void check_net_flux(const SideVelocities<Dim>& velocities) {
  const auto moves = [](const auto& ends) { return ends[0].motion || ends[1].motion; };
  if (!velocities.open().empty() || std::ranges::any_of(velocities.sides(), moves)) return;
  const auto [net, gross] = velocities.prescribed_flux(0);
  if (std::abs(net) > 1e-12 * gross)
    throw InputError("-bc_..._velocity: the velocities given on the boundary have a net flux of " + to_text(net) +
                     " m^" + std::to_string(Dim) + "/s out of the box; it must be zero, or one side an outflow");
}
}  // namespace

template <int Dim>
Boundary<Dim>::Boundary(const Grid<Dim>& grid, Sides sides) : grid_(grid), velocities_(grid, std::move(sides)) {
  check_net_flux(velocities_);
}

template <int Dim>
void Boundary<Dim>::start_outflow(Vec local_velocity, double time) {
  if (has_outflow()) velocities_.open().start(local_velocity, velocities_.prescribed_flux(time).net, time);
}

template <int Dim>
void Boundary<Dim>::advance_outflow(Vec local_velocity, double time, double dt) {
  if (!has_outflow()) return;
  const double end = time + dt;
  velocities_.open().advance(local_velocity, velocities_.prescribed_flux(end).net, end, dt);
}

template <int Dim>
double Boundary<Dim>::mirror_sign(int axis, End end, int component) const {
  if (grid_.periodic(axis)) return 0;
  const BoundaryKind kind = side(axis, end).kind;
  if (kind == BoundaryKind::outflow) return 0;
  return kind == BoundaryKind::slip && component != axis ? 1 : -1;
}

// Fills from values(axis, end, component, use), which calls use as `SideVelocities::with_values` does.
template <int Dim>
template <class Values>
void Boundary<Dim>::fill_from(Vec local, Values&& values) const {
  const FaceView<Dim> u(petsc::dm_of(local), local);
  const Box<Dim> part = ghosted_box<Dim>(local);
  for_each_component<Dim>([&](auto axis) {  // later axes complete the corners of earlier ones
    for (const End end : both_ends) {
      if (!touches(grid_, axis, end)) continue;
      values(axis, end, axis, [&](const auto& value) {
        for_each_side_face(grid_, axis, end, part, [&](const Index<Dim>& face) { u(face, axis) = value(face); });
      });
      for_each_component<Dim>([&](auto c) {
        const double sign = mirror_sign(axis, end, c);  // u(ghost) = (1 - sign) u_wall + sign u(mirror)
        values(axis, end, c, [&](const auto& value) {
          for_each_ghost<axis>(grid_, end, c, part, [&](const Index<Dim>& ghost, const Index<Dim>& mirror) {
            u(ghost, c) = (1 - sign) * value(ghost) + sign * u(mirror, c);
          });
        });
      });
    }
  });
}

template <int Dim>
void Boundary<Dim>::fill(Vec local_velocity, double time) const {
  fill_from(local_velocity,
            [&](int axis, End end, int c, const auto& use) { velocities_.with_values(axis, end, c, time, use); });
}

template <int Dim>
void Boundary<Dim>::fill_from_sides(Vec local, double time, const SideSet& sides,
                                    const std::optional<SideName>& open) const {
  WASH_PETSC(VecZeroEntries(local));
  fill_from(local, [&](int axis, End end, int c, const auto& use) {
    if (!sides[axis][end == End::upper ? 1 : 0]) return;
    const auto* covered = covers().of(axis, end);
    const bool is_open = open && axis == open->axis && end == open->end;
    if (covered && (is_open || !open))
      use([is_open, shares = covered->shares(c, time)](const Index<Dim>& face) {
        return is_open ? 1 - shares(face) : shares(face);
      });
    else
      use([same = is_open ? 1.0 : 0.0](const Index<Dim>&) { return same; });
  });
}

template <int Dim>
void Boundary<Dim>::fill_homogeneous(Vec local_velocity) const {
  fill_from(local_velocity, [](int, End, int, const auto& use) { use([](const Index<Dim>&) { return 0.0; }); });
}

template <int Dim>
void Boundary<Dim>::fill_cells(Vec local_cells) const {
  const CellView<Dim> values(petsc::dm_of(local_cells), local_cells);
  const Box<Dim> part = ghosted_box<Dim>(local_cells);
  for_each_component<Dim>([&](auto axis) {
    constexpr int beside = (axis + 1) % Dim;  // cells lie half a spacing from the side, as the faces of the others do
    const auto copy = [&](const Index<Dim>& ghost, const Index<Dim>& mirror) { values(ghost) = values(mirror); };
    for (const End end : both_ends)
      if (touches(grid_, axis, end)) for_each_ghost<axis>(grid_, end, beside, part, copy);
  });
}

template <int Dim>
Point<Dim> Boundary<Dim>::fold_with(Vec local, bool keep_sign) const {
  const FaceView<Dim> f(petsc::dm_of(local), local);
  const Box<Dim> part = ghosted_box<Dim>(local);
  Point<Dim> kept = Point<Dim>::Zero();
  for_each_component<Dim>([&](auto number) {
    constexpr int axis = Dim - 1 - number;  // the reverse of `fill`
    for (const End end : both_ends) {
      if (!touches(grid_, axis, end)) continue;
      for_each_component<Dim>([&](auto c) {
        const double sign = keep_sign ? 1 : mirror_sign(axis, end, c);
        for_each_ghost<axis>(grid_, end, c, part, [&](const Index<Dim>& ghost, const Index<Dim>& mirror) {
          if (f(ghost, c) == 0) return;  // most are 0
          f(mirror, c) += sign * f(ghost, c);
          kept[c] += (1 - sign) * f(ghost, c);
          f(ghost, c) = 0;
        });
      });
      if (keep_sign) continue;
      for_each_side_face(grid_, axis, end, part,
                         [&](const Index<Dim>& face) { kept[axis] += std::exchange(f(face, axis), 0.0); });
    }
  });
  return kept;
}

template <int Dim>
Point<Dim> Boundary<Dim>::fold(Vec local_force) const {
  return fold_with(local_force, false);
}

template <int Dim>
void Boundary<Dim>::fold_mass(Vec local_density) const {
  (void)fold_with(local_density, true);
}

template <int Dim>
void Boundary<Dim>::set_boundary_faces(Vec velocity, double time) const {
  const FaceView<Dim> u(grid_.face_dm(), velocity);
  for (int axis = 0; axis < Dim; ++axis) {
    if (!touches(grid_, axis, End::lower)) continue;
    for_each_side_face(grid_, axis, End::lower, grid_.owned(), [&](const Index<Dim>& face) {
      u(face, axis) = velocities_.value(axis, End::lower, face, axis, time);
    });
  }
}

template class Boundary<2>;
template class Boundary<3>;

}  // namespace washfsi
