// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "washfsi/grid/side_velocities.hpp"

namespace washfsi {

/// The conditions on all sides of the box, as values of ghost faces. The tangential velocity is reflected through a
/// wall or inflow, ghost = 2 u_wall - u_mirror (thesis Fig. 2.2-3), or mirrored at a slip side. Faces in the boundary
/// take the given normal velocity. At an outflow all of them are the values that the flow has carried there
/// (`OutflowLayer`), shifted so that outflow exactly balances inflow.
template <int Dim>
class Boundary {
 public:
  using Sides = washfsi::Sides<Dim>;

  /// Collective. Errors: InputError if there is no outflow and the prescribed velocities have a net flux.
  Boundary(const Grid<Dim>& grid, Sides sides);

  /// Fills boundary faces and ghosts of a local face vector, of `face_dm` or `wide_face_dm`, whose inner ghosts are up
  /// to date.
  void fill(Vec local_velocity, double time) const;
  /// Fills as `fill` with all walls at rest: its linear part.
  void fill_homogeneous(Vec local_velocity) const;
  /// Adjoint of the linear part: adds what lies on ghosts back to the faces they mirror and clears them.
  /// Returns the part that the sides take, summed over this rank's entries.
  Point<Dim> fold(Vec local_force) const;
  /// Adds ghosts of a mass density back with unchanged sign, so that mass beyond a side is not lost.
  void fold_mass(Vec local_density) const;
  /// Fills the ghosts of a local cell vector beyond the sides with the values that they mirror: zero normal gradient.
  void fill_cells(Vec local_cells) const;
  /// Sets the owned faces in the lower boundaries of a global velocity.
  void set_boundary_faces(Vec velocity, double time) const;

  /// Starts the open sides with the values inside, at `time`. `local_velocity` has wide ghosts. Collective.
  void start_outflow(Vec local_velocity, double time);
  /// Computes the values of the open sides after a step from `time` by `dt`, for all calls with a later time; the
  /// velocity is that at `time`, filled, with wide ghosts. May be repeated. Collective.
  void advance_outflow(Vec local_velocity, double time, double dt);
  bool has_outflow() const { return !velocities_.open().empty(); }
  /// Makes the advanced values of the open sides the present ones.
  void accept_outflow() { velocities_.open().accept(); }
  /// Registers the values of the open sides.
  void register_state(StateList& state) { velocities_.open().register_state(state); }

  /// The covers of no-slip sides by bodies that stand on them.
  SideCovers<Dim>& covers() { return velocities_.covers(); }
  const SideCovers<Dim>& covers() const { return velocities_.covers(); }
  /// A set of sides: whether each belongs to it, by axis and end.
  using SideSet = std::array<std::array<bool, 2>, Dim>;
  /// Fills a local face vector, at and beyond the sides of a set, as `fill` would for water at rest and a velocity of 1
  /// in all directions on the covered part of the sides or, if `open` names a side, on the open part of this side. J of
  /// it is the share of a marker's force that sides take.
  void fill_from_sides(Vec local, double time, const SideSet& sides, const std::optional<SideName>& open) const;

  const Side<Dim>& side(int axis, End end) const { return side_of<Dim>(velocities_.sides(), axis, end); }
  /// +1 or -1: the sign with which a ghost of this component mirrors the interior; 0 if it does not, on periodic and
  /// open sides.
  double mirror_sign(int axis, End end, int component) const;
  /// Largest speed prescribed anywhere on the boundary [m/s]. Collective.
  double largest_speed(double time) const { return velocities_.largest_prescribed(time); }

 private:
  Point<Dim> fold_with(Vec local, bool keep_sign) const;
  template <class Values>
  void fill_from(Vec local, Values&& values) const;

  const Grid<Dim>& grid_;
  SideVelocities<Dim> velocities_;
};

/// A temporary local copy, in a DM of the grid's faces, of a velocity with its boundary faces and ghosts filled for a
/// time. Collective.
template <int Dim>
class GhostedVelocity : public petsc::LocalVector {
 public:
  GhostedVelocity(const Boundary<Dim>& boundary, DM dm, Vec velocity, double time) : LocalVector(dm, velocity) {
    boundary.fill(*this, time);
  }
};

extern template class Boundary<2>;
extern template class Boundary<3>;

}  // namespace washfsi
