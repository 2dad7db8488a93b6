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
constexpr std::array<End, 2> both_ends{End::lower, End::upper};
}

template <int Dim>
Boundary<Dim>::Boundary(const Grid<Dim>& grid, Sides sides) : grid_(grid), sides_(std::move(sides)) {
  check_net_flux();
}

template <int Dim>
void Boundary<Dim>::check_net_flux() const {
  double net = 0, gross = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    if (grid_.periodic(axis)) continue;
    const Point<Dim> extent = grid_.upper() - grid_.lower();
    const double area = extent.prod() / extent[axis];
    const double in = area * side(axis, End::lower).velocity[axis];
    const double out = area * side(axis, End::upper).velocity[axis];
    net += out - in;
    gross += std::abs(out) + std::abs(in);
  }
  if (std::abs(net) > 1e-12 * gross)
    throw InputError("-bc_..._velocity: the velocities given on the boundary have a net outflow of " + to_text(net) +
                     " m^" + std::to_string(Dim) + "/s; it must be zero");
}

template <int Dim>
const Side<Dim>& Boundary<Dim>::side(int axis, End end) const {
  return sides_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)];
}

template <int Dim>
double Boundary<Dim>::mirror_sign(int axis, End end, int component) const {
  if (grid_.periodic(axis)) return 0;
  return side(axis, end).kind == BoundaryKind::slip && component != axis ? 1 : -1;
}

template <int Dim>
double Boundary<Dim>::largest_speed(double time) const {
  double speed = 0;
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends) {
      if (grid_.periodic(axis) || !touches(axis, end)) continue;
      visit_boundary_faces(axis, end, [&](const Index<Dim>& face) {
        for (int c = 0; c < Dim; ++c)
          if (c == axis || side(axis, end).kind == BoundaryKind::wall)
            speed = std::max(speed, std::abs(value(side(axis, end), grid_.face_center(face, axis), time, c)));
      });
    }
  return largest(grid_.comm(), speed);
}

template <int Dim>
bool Boundary<Dim>::touches(int axis, End end) const {
  const auto d = static_cast<std::size_t>(axis);
  return end == End::lower ? grid_.owned().lower[d] == 0 : grid_.owned().upper[d] == grid_.cells()[d];
}

template <int Dim>
double Boundary<Dim>::value(const Side<Dim>& side, const Point<Dim>& place, double time, int component) const {
  return side.motion ? side.motion(place, time)[component] : side.velocity[component];
}

// The point of the wall opposite to a face.
template <int Dim>
Point<Dim> Boundary<Dim>::foot(const Index<Dim>& face, int component, int axis, End end) const {
  Point<Dim> place = grid_.face_center(face, component);
  place[axis] = end == End::lower ? grid_.lower()[axis] : grid_.upper()[axis];
  return place;
}

// Calls visit(face) for the faces that lie in the boundary, over the whole local extent of the other axes.
template <int Dim>
template <class Visit>
void Boundary<Dim>::visit_boundary_faces(int axis, End end, Visit&& visit) const {
  const auto d = static_cast<std::size_t>(axis);
  Box<Dim> plane = grid_.local();
  plane.lower[d] = end == End::lower ? 0 : grid_.cells()[d];
  plane.upper[d] = plane.lower[d] + 1;
  for_each<Dim>(plane, visit);
}

// Calls visit(ghost, mirror) for the ghosts beyond one side and the face that each mirrors.
template <int Dim>
template <class Visit>
void Boundary<Dim>::visit_ghosts(int axis, End end, int component, Visit&& visit) const {
  const auto d = static_cast<std::size_t>(axis);
  const bool normal = component == axis;  // faces lie in the boundary, not half a cell from it
  const PetscInt n = grid_.cells()[d];
  Box<Dim> beyond = grid_.local();
  if (end == End::lower)
    beyond.upper[d] = 0;
  else
    beyond.lower[d] = normal ? n + 1 : n;
  const PetscInt pivot = (end == End::lower ? 0 : 2 * n) - (normal ? 0 : 1);
  for_each<Dim>(beyond, [&](const Index<Dim>& ghost) {
    Index<Dim> mirror = ghost;
    mirror[d] = pivot - ghost[d];
    visit(ghost, mirror);
  });
}

template <int Dim>
void Boundary<Dim>::fill(Vec local_velocity, double time) const {
  const FaceView<Dim> u(grid_.face_dm(), local_velocity);
  for (int axis = 0; axis < Dim; ++axis)  // later axes complete the corners of earlier ones
    for (const End end : both_ends) {
      if (grid_.periodic(axis) || !touches(axis, end)) continue;
      const Side<Dim>& wall = side(axis, end);
      visit_boundary_faces(axis, end, [&](const Index<Dim>& face) {
        u(face, axis) = value(wall, grid_.face_center(face, axis), time, axis);
      });
      for (int c = 0; c < Dim; ++c) {
        const double sign = mirror_sign(axis, end, c);
        visit_ghosts(axis, end, c, [&](const Index<Dim>& ghost, const Index<Dim>& mirror) {
          const double shift = sign < 0 ? 2 * value(wall, foot(ghost, c, axis, end), time, c) : 0;
          u(ghost, c) = shift + sign * u(mirror, c);
        });
      }
    }
}

template <int Dim>
void Boundary<Dim>::fill_homogeneous(Vec local_velocity) const {
  const FaceView<Dim> u(grid_.face_dm(), local_velocity);
  for (int axis = 0; axis < Dim; ++axis)
    for (const End end : both_ends) {
      if (grid_.periodic(axis) || !touches(axis, end)) continue;
      visit_boundary_faces(axis, end, [&](const Index<Dim>& face) { u(face, axis) = 0; });
      for (int c = 0; c < Dim; ++c) {
        const double sign = mirror_sign(axis, end, c);
        visit_ghosts(axis, end, c,
                     [&](const Index<Dim>& ghost, const Index<Dim>& mirror) { u(ghost, c) = sign * u(mirror, c); });
      }
    }
}

template <int Dim>
Point<Dim> Boundary<Dim>::fold_with(Vec local, bool keep_sign) const {
  const FaceView<Dim> f(grid_.face_dm(), local);
  Point<Dim> kept = Point<Dim>::Zero();
  for (int axis = Dim; axis-- > 0;)  // the reverse of `fill`
    for (const End end : both_ends) {
      if (grid_.periodic(axis) || !touches(axis, end)) continue;
      for (int c = 0; c < Dim; ++c) {
        const double sign = keep_sign ? 1 : mirror_sign(axis, end, c);
        visit_ghosts(axis, end, c, [&](const Index<Dim>& ghost, const Index<Dim>& mirror) {
          f(mirror, c) += sign * f(ghost, c);
          kept[c] += (1 - sign) * f(ghost, c);
          f(ghost, c) = 0;
        });
      }
      if (keep_sign) continue;
      visit_boundary_faces(axis, end, [&](const Index<Dim>& face) { kept[axis] += std::exchange(f(face, axis), 0.0); });
    }
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
    if (grid_.periodic(axis) || !touches(axis, End::lower)) continue;
    Box<Dim> plane = grid_.owned();
    plane.upper[static_cast<std::size_t>(axis)] = 1;
    for_each<Dim>(plane, [&](const Index<Dim>& face) {
      u(face, axis) = value(side(axis, End::lower), grid_.face_center(face, axis), time, axis);
    });
  }
}

template class Boundary<2>;
template class Boundary<3>;

}  // namespace washfsi
