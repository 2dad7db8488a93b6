// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>

#include "washfsi/grid/grid.hpp"

namespace washfsi {

enum class BoundaryKind { wall, slip, periodic };

enum class End { lower, upper };

/// What holds on one side of the box.
template <int Dim>
struct Side {
  BoundaryKind kind = BoundaryKind::wall;
  Point<Dim> velocity = Point<Dim>::Zero();  ///< of the wall [m/s]; slip uses the normal component only
  /// If set, the wall's velocity [m/s] at a place [m] and time [s], instead of `velocity`.
  std::function<Point<Dim>(const Point<Dim>&, double)> motion;
};

/// The conditions on all sides of the box, as values of ghost faces: the tangential velocity is reflected
/// through the wall, ghost = 2 u_wall - u_interior (thesis Fig. 2.2-3), or mirrored at a slip side; faces in
/// the boundary take the wall's normal velocity.
template <int Dim>
class Boundary {
 public:
  using Sides = std::array<std::array<Side<Dim>, 2>, Dim>;  ///< [axis][End]

  /// Errors: InputError if the prescribed velocities have a net flux through the boundary.
  Boundary(const Grid<Dim>& grid, Sides sides);

  /// Fills boundary faces and ghosts of a local face vector whose inner ghosts are up to date.
  void fill(Vec local_velocity, double time) const;
  /// The linear part of `fill`: as if all walls were at rest.
  void fill_homogeneous(Vec local_velocity) const;
  /// Adjoint of the linear part: adds what lies on ghosts back to the faces they mirror and clears them.
  /// Returns what the walls keep, summed over this rank's entries.
  Point<Dim> fold(Vec local_force) const;
  /// Adds ghosts of a mass density back with their sign kept, so that mass beyond a wall is not lost.
  void fold_mass(Vec local_density) const;
  /// Sets the owned faces in the lower boundaries of a global velocity.
  void set_boundary_faces(Vec velocity, double time) const;

  const Side<Dim>& side(int axis, End end) const;
  /// +1 or -1: the sign with which a ghost of this component mirrors the interior; 0 on periodic sides.
  double mirror_sign(int axis, End end, int component) const;
  /// Largest speed prescribed anywhere on the boundary [m/s].
  double largest_speed(double time) const;

 private:
  template <class Visit>
  void visit_ghosts(int axis, End end, int component, Visit&& visit) const;
  template <class Visit>
  void visit_boundary_faces(int axis, End end, Visit&& visit) const;
  Point<Dim> fold_with(Vec local, bool keep_sign) const;
  bool touches(int axis, End end) const;
  double value(const Side<Dim>& side, const Point<Dim>& place, double time, int component) const;
  void check_net_flux() const;
  Point<Dim> foot(const Index<Dim>& face, int component, int axis, End end) const;

  const Grid<Dim>& grid_;
  Sides sides_;
};

extern template class Boundary<2>;
extern template class Boundary<3>;

}  // namespace washfsi
