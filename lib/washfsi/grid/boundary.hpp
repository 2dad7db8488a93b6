// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "washfsi/grid/grid.hpp"
#include "washfsi/grid/outflow.hpp"
#include "washfsi/grid/side.hpp"
#include "washfsi/grid/side_cover.hpp"

namespace washfsi {

/// The conditions on all sides of the box, as values of ghost faces: the tangential velocity is reflected
/// through a wall or inflow, ghost = 2 u_wall - u_interior (thesis Fig. 2.2-3), or mirrored at a slip side; faces in
/// the boundary take the given normal velocity. At an outflow all of them are the values that the flow has carried
/// there (`OutflowLayer`), shifted so that outflow exactly balances inflow.
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
  /// Makes the advanced values the present ones.
  void accept_outflow();
  bool has_outflow() const { return !outflows_.empty(); }
  /// Registers the values of the open sides.
  void register_state(StateList& state) {
    for (auto& layer : outflows_) layer.register_state(state);
    if (has_outflow()) state.add_number("/outflow/time", outflow_time_);
  }

  /// Sets the cover of no-slip sides at `time`: where bodies stand on them, sides have the bodies' tangential velocity.
  void cover_sides(double time, const typename SideCover<Dim>::Cover& cover);
  /// Whether a cover has been set, as from the first step on; below, forgets it.
  bool knows_cover() const { return !covers_.empty(); }
  void forget_cover() { covers_.clear(); }

  /// The share of bodies on a side at the place beside a face; 0 where none stands.
  double covered_share(int axis, End end, const Index<Dim>& face, int component, double time) const {
    const auto* covered = cover(axis, end);
    return covered ? covered->shares(component, time)(face) : 0;
  }
  /// Whether bodies cover all of this rank's part of a side.
  bool covered_wholly(int axis, End end) const {
    const auto* covered = cover(axis, end);
    return !touches(axis, end) || (covered && covered->covers_all());
  }
  /// A set of sides: whether each belongs to it, by axis and end.
  using SideSet = std::array<std::array<bool, 2>, Dim>;
  /// Fills a local face vector, at and beyond the sides of a set, as `fill` would for water at rest and a velocity of 1
  /// in all directions on the covered part of the sides or, if `open` names a side, on the open part of this side. J of
  /// it is the share of a marker's force that sides take.
  void fill_from_sides(Vec local, double time, const SideSet& sides, const std::optional<SideName>& open) const;

  const Side<Dim>& side(int axis, End end) const;
  /// +1 or -1: the sign with which a ghost of this component mirrors the interior; 0 if it does not, on periodic and
  /// open sides.
  double mirror_sign(int axis, End end, int component) const;
  /// Largest speed prescribed anywhere on the boundary [m/s].
  double largest_speed(double time) const;

 private:
  template <int Axis, class Visit>
  void visit_ghosts(End end, int component, const Box<Dim>& part, Visit&& visit) const;
  template <class Visit>
  void visit_boundary_faces(int axis, End end, const Box<Dim>& part, Visit&& visit) const;
  Point<Dim> fold_with(Vec local, bool keep_sign) const;
  bool touches(int axis, End end) const {
    if (grid_.periodic(axis)) return false;
    return end == End::lower ? grid_.owned().lower[axis] == 0 : grid_.owned().upper[axis] == grid_.cells()[axis];
  }
  double value(int axis, End end, const Index<Dim>& face, int component, double time) const;
  template <class Use>
  void with_values(int axis, End end, int component, double time, Use&& use) const;
  template <class Values>
  void fill_from(Vec local, Values&& values) const;
  struct Flux {
    double net, gross;
  };
  Flux prescribed_flux(double time) const;
  void balance_outflow(double time);
  const OutflowLayer<Dim>& outflow(int axis, End end) const;
  void check_net_flux() const;
  const SideCover<Dim>* cover(int axis, End end) const;
  Point<Dim> foot(const Index<Dim>& face, int component, int axis, End end) const;

  const Grid<Dim>& grid_;
  Sides sides_;
  std::vector<OutflowLayer<Dim>> outflows_;
  std::vector<SideCover<Dim>> covers_;
  double outflow_time_ = 0, next_outflow_time_ = 0;  ///< times of the present and the advanced values [s]
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
