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
  /// For `BodyMethod::ghost` only: sets the constraint velocity of faces inside the walls by extrapolation of the
  /// velocity through the wall (Yokoi 2003, thesis 4.3.1.2). The velocity has wide ghosts, filled.
  void extrapolate(Vec local_velocity, double time);

  /// Lets the constrained water inside bodies slide: add(H, velocity) adds to the bodies' velocity on faces.
  template <class Add>
  void let_slide(const Add& add) {
    if (!constraint_velocity_) constraint_velocity_ = grid_.face_vector();
    WASH_PETSC(VecCopy(solid_velocity_, constraint_velocity_));
    add(static_cast<Vec>(fraction_), static_cast<Vec>(constraint_velocity_));
    slides_ = true;
  }

  /// Counts faces where `near` is 1 as water: along thin parts and edges past which water slides, the water behind
  /// walls moves with that before them, not with the body. `near` is on faces, from 0 to 1. Valid until the next
  /// `update`.
  void count_as_water(Vec near);

  /// H half a cell behind a surface in direct forcing, where H is smooth: 1/2 (1 - 1/2 - 1/pi).
  static constexpr double fraction_half_a_cell_behind = 0.0908;

  Vec fluid_fraction() const { return fraction_; }  ///< H, on faces; null without bodies, as the others
  /// The fluid volume fraction of each face. With direct forcing it differs from H, which is 0 only deep inside bodies,
  /// where the mask constrains the water.
  Vec fluid_share() const { return share_ ? share_ : fraction_; }
  Vec solid_velocity() const { return solid_velocity_; }  ///< on faces [m/s]
  /// The cover of the box's sides by bodies, whose velocity they have by the bodies' share. Valid as long as `posed`.
  typename SideCover<Dim>::Cover cover(const PosedBodies<Dim>& posed) const;
  bool empty() const { return bodies_.empty(); }
  bool extrapolates() const { return treatment_.method == BodyMethod::ghost && !empty(); }
  /// The constraint for the fluid's equations; valid until the next `update`.
  Constraint<Dim> constraint() const;

  /// Replaces velocity by H velocity + (1 - H) solid velocity, which moves the markers. Collective.
  void apply(Vec velocity) const;

  /// Load on each body from the constraint force density of the bodies over a step, null if there is none, less the
  /// inertia of the water inside them, and the pressure on sides of the box that bodies cover. `time` is the middle of
  /// the step. Collective.
  Loads<Dim> loads(Vec constraint_force, Vec density, Vec pressure, double time) const;

  /// The momentum of the water inside each body relative to rigid motion with it, and its angular momentum about the
  /// body's centre. Its growth over a step, over dt, must be added to `loads` on a body behind whose walls water lags
  /// or slides. Collective.
  Loads<Dim> inner_momentum(Vec velocity, Vec density, double time) const;

  /// Energy that the water lost in a step of dt to the moving mask: 1/2 rho |u_solid - u|^2 on the faces
  /// that are solid now, u the velocity before, over dt [W; in the plane W/m]. An effect of the staircase. Collective.
  double dissipation(Vec velocity_before, Vec density, double dt) const;

  /// The drag of the box's sides at rest on the water inside each body, which is not the body's; to be added to `loads`
  /// where a body moves along a side. The velocity is that at `time`, local, of face_dm, its ghosts filled. Collective.
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
  std::vector<double> constrained_depths_;  ///< `InnerWater`'s for each body in direct forcing, else 0 [m]
  std::vector<CutFace<Dim>> cuts_;
  // all null without bodies
  petsc::Vector fraction_, solid_velocity_;
  petsc::Vector share_;                ///< fluid share in direct forcing; else null
  petsc::Vector constraint_velocity_;  ///< velocity imposed on faces; null if it is the bodies' velocity [m/s]
  petsc::Vector body_;                 ///< number of the body that covers each face; -1 in fluid
  petsc::Vector resting_fraction_, resting_share_, resting_body_;  ///< for the bodies at rest alone; null if all rest
  bool any_moves_, slides_ = false;
};

extern template class Mask<2>;
extern template class Mask<3>;

}  // namespace washfsi
