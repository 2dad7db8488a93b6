// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/grid/constraint.hpp"
#include "washfsi/grid/viscous_stress.hpp"
#include "washfsi/motion/body.hpp"
#include "washfsi/motion/load.hpp"

namespace washfsi {

/// The bodies on the faces of a grid: the fluid fraction H, a function of the signed distance Phi, and the velocity of
/// the solid (4.2-6). Sharp: H = 0 in the solid, 1/2 on its surface, 1 in fluid. Smooth over |Phi| < eps = 2h:
///   H = 1/2 (1 + Phi/eps + sin(pi Phi/eps)/pi).
template <int Dim>
class Mask {
 public:
  /// Collective.
  Mask(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, const BodyTreatment& treatment);

  /// Places the bodies as they are at `time`. Collective.
  void update(double time);
  /// For `BodyMethod::ghost`, else nothing: sets what the faces inside the walls are held at, by extrapolation of the
  /// velocity through the wall (Yokoi 2003, thesis 4.3.1.2). The velocity is filled and has wide ghosts.
  void extrapolate(Vec local_velocity, double time);

  /// Lets the water that the bodies hold slide: add(H, velocity) adds to the bodies' velocity on faces.
  template <class Add>
  void let_slide(const Add& add) {
    if (!constraint_velocity_) constraint_velocity_ = grid_.face_vector();
    WASH_PETSC(VecCopy(solid_velocity_, constraint_velocity_));
    add(static_cast<Vec>(fraction_), static_cast<Vec>(constraint_velocity_));
    slides_ = true;
  }

  /// Counts all of what lies where `near` is 1 as water: along thin parts and edges that it slides by, that behind
  /// walls goes with the water before them, not with the body. `near` is of faces, from 0 to 1; until the next
  /// `update`.
  void count_as_water(Vec near);

  /// H where markers hold the walls: smooth, 1/2 (1 - 1/2 - 1/pi).
  static constexpr double fraction_half_a_cell_behind = 0.0908;

  Vec fluid_fraction() const { return fraction_; }  ///< H, on faces; null without bodies, as the others
  /// The share of each face that lies in fluid: H, but where markers hold the walls and H is 0 only behind them.
  Vec fluid_share() const { return share_ ? share_ : fraction_; }
  Vec solid_velocity() const { return solid_velocity_; }  ///< on faces [m/s]
  /// What bodies make of the sides of the box, which have their velocities by their share. Valid as long as `posed`.
  typename SideCover<Dim>::Cover cover(const PosedBodies<Dim>& posed) const;
  bool empty() const { return bodies_.empty(); }
  bool extrapolates() const { return treatment_.method == BodyMethod::ghost && !empty(); }
  /// What the fluid's equations need of it; valid until the next `update`.
  Constraint<Dim> constraint() const;

  /// velocity becomes H velocity + (1 - H) solid velocity: what moves the markers. Collective.
  void apply(Vec velocity) const;

  /// Load on each body from the force density by which the bodies held the water over a step, null if they did not,
  /// less the inertia of the water inside them, and what the walls of the box held for them: their pressure. `time` is
  /// the middle of the step. Collective.
  Loads<Dim> loads(Vec constraint_force, Vec density, Vec pressure, double time) const;

  /// The momentum of the water inside each body beyond that with which it would move with it, and its angular
  /// momentum about the body's centre: by as much as it grew over a step, over dt, `loads` are too small on a body
  /// behind whose walls it lags or slides. Collective.
  Loads<Dim> inner_momentum(Vec velocity, Vec density, double time) const;

  /// Energy that the water lost in a step of dt where a moving mask took it along: 1/2 rho |u_solid - u|^2 on the faces
  /// that are solid now, u the velocity before, over dt [W; in the plane W/m]. An effect of the staircase. Collective.
  double dissipation(Vec velocity_before, Vec density, double dt) const;

  /// The drag of walls of the box at rest on the water inside each body, which is not the body's: what `loads` must be
  /// given on top where a body moves along a wall. The velocity is that at `time`, local, of face_dm, its ghosts
  /// filled. Collective.
  Loads<Dim> hidden_wall_shear(const Boundary<Dim>& boundary, Vec local_velocity, const Viscosity& viscosity,
                               double time) const;

 private:
  void create_fields();
  template <class Visit>
  void for_each_inside(const PosedBodies<Dim>& posed, std::size_t body, double reach, const Visit& visit) const;
  void place(const PosedBodies<Dim>& posed, std::size_t body);
  double fraction_at(double distance) const;
  Covered<Dim> covered(const Point<Dim>& place, const Point<Dim>& own, const PosedBodies<Dim>& posed,
                       bool by_moving) const;
  void find_cuts(const PosedBodies<Dim>& posed);
  void add_constraint_force(Vec constraint_force, Vec density, double time, Loads<Dim>& loads) const;
  void add_wall_pressure(Vec pressure, double time, Loads<Dim>& loads) const;
  template <class Form>
  void add_hidden_shear(const Boundary<Dim>& boundary, int axis, End end, const ConstFaceView<Dim>& u,
                        const Form& viscosity, double time, Loads<Dim>& loads) const;

  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  BodyTreatment treatment_;
  double smoothing_;                        ///< eps [m]; 0: sharp
  std::vector<double> constrained_depths_;  ///< behind each body's walls, if markers hold them; else 0 [m]
  std::vector<CutFace<Dim>> cuts_;
  // all null without bodies
  petsc::Vector fraction_, solid_velocity_;
  petsc::Vector share_;                ///< null unless markers hold the walls
  petsc::Vector constraint_velocity_;  ///< what faces are held at; null if at the bodies' velocity [m/s]
  petsc::Vector body_;                 ///< number of the body that holds each face; -1 in fluid
  petsc::Vector resting_fraction_, resting_share_, resting_body_;  ///< of the bodies at rest alone; null if no other is
  bool any_moves_, slides_ = false;
};

extern template class Mask<2>;
extern template class Mask<3>;

}  // namespace washfsi
