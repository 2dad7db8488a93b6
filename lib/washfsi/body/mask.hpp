// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/body.hpp"
#include "washfsi/grid/constraint.hpp"
#include "washfsi/grid/grid.hpp"

namespace washfsi {

/// Force and torque of the water and cloth ON a body; the torque is about where the body's centre is [N, N m; per unit
/// depth in the plane].
template <int Dim>
struct Load {
  Point<Dim> force = Point<Dim>::Zero();
  Rotation<Dim> torque = Rotation<Dim>::Zero();
};

/// The bodies on the faces of a grid: the sharp mask H (0 in solid, 1/2 on its surface, 1 in fluid) and the velocity of
/// the solid (4.2-6).
template <int Dim>
class Mask {
 public:
  Mask(const Grid<Dim>& grid, const std::vector<Body<Dim>>& bodies, BodyMethod method);

  /// Places the bodies as they are at `time`.
  void update(double time);

  Vec fluid_fraction() const { return fraction_; }        ///< H, on faces
  Vec solid_velocity() const { return solid_velocity_; }  ///< on faces [m/s]
  bool empty() const { return bodies_.empty(); }
  /// What the momentum equation needs of it; valid until the next `update`.
  Constraint<Dim> constraint() const;

  /// velocity becomes H velocity + (1 - H) solid velocity: what moves the markers. Collective.
  void hold(Vec velocity) const;

  /// Load on each body from the force density by which the bodies held the water over a step that ended at `time`,
  /// less the inertia of the water inside them and what the walls of the box held for them: their pressure, not their
  /// shear, so a drum that reaches the walls and turns lacks the shear of its corners there. Collective.
  std::vector<Load<Dim>> loads(Vec constraint_force, Vec density, Vec pressure, double time) const;

 private:
  void place_bodies_at_rest();
  void find_cuts(double time);
  typename CutFace<Dim>::Arm arm_towards(const Index<Dim>& face, int component, int axis, int step, double time,
                                         double here, int& body) const;
  struct Sums;
  void add_constraint_force(Vec constraint_force, Vec density, double time, Sums& sums) const;
  void add_wall_pressure(Vec pressure, double time, Sums& sums) const;

  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  BodyMethod method_;
  std::vector<CutFace<Dim>> cuts_;
  petsc::Vector fraction_, solid_velocity_;
  petsc::Vector body_;     ///< number of the body that holds each face; -1 in fluid
  petsc::Vector resting_;  ///< number of the body at rest that holds each face, before any moving one; -1 if none
};

extern template class Mask<2>;
extern template class Mask<3>;

}  // namespace washfsi
