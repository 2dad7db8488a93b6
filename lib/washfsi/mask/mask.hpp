// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/grid/constraint.hpp"
#include "washfsi/mask/fluid_fraction.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// The bodies on the faces of a grid: the fluid fraction H (`fluid_fraction.hpp`) and the velocity of the solid
/// (4.2-6).
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
    add(fluid_fraction(), static_cast<Vec>(constraint_velocity_));
    slides_ = true;
  }

  /// Counts faces where `near` is 1 as water: along thin parts and edges past which water slides, the water behind
  /// walls moves with that before them, not with the body. `near` is on faces, from 0 to 1. Valid until the next
  /// `update`.
  void count_as_water(Vec near);

  /// H half a cell behind a surface in direct forcing, where H is smooth: 1/2 (1 - 1/2 - 1/pi).
  static constexpr double fraction_half_a_cell_behind = 0.0908;

  Vec fluid_fraction() const { return fields_.fraction; }  ///< H, on faces; null without bodies, as the others
  /// The fluid volume fraction of each face. With direct forcing it differs from H, which is 0 only deep inside bodies,
  /// where the mask constrains the water.
  Vec fluid_share() const { return fields_.share ? fields_.share : fields_.fraction; }
  Vec solid_velocity() const { return solid_velocity_; }  ///< on faces [m/s]
  /// The number of the body that each face belongs to, -1 in fluid.
  Vec body_of_faces() const { return fields_.body; }
  const Grid<Dim>& grid() const { return grid_; }
  const std::vector<Body<Dim>>& bodies() const { return bodies_; }
  /// The cover of the box's sides by bodies, whose velocity they have by the bodies' share. Valid as long as `posed`.
  typename SideCover<Dim>::Cover cover(const PosedBodies<Dim>& posed) const;
  bool empty() const { return bodies_.empty(); }
  bool extrapolates() const { return treatment_.method == BodyMethod::ghost && !empty(); }
  /// The constraint for the fluid's equations; valid until the next `update`.
  Constraint<Dim> constraint() const;

  /// Replaces velocity by H velocity + (1 - H) solid velocity, which moves the markers. Collective.
  void apply(Vec velocity) const;

 private:
  void create_fields();
  template <class Visit>
  void for_each_inside(const PosedBodies<Dim>& posed, std::size_t body, double reach, const Visit& visit) const;
  void place(const PosedBodies<Dim>& posed, std::size_t body);

  /// The fields of some bodies on faces.
  struct Fields {
    petsc::Vector fraction;  ///< H
    petsc::Vector share;     ///< fluid share in direct forcing; else null
    petsc::Vector body;      ///< number of the body that a face belongs to; -1 in fluid
  };
  static void copy(const Fields& from, Fields& to);

  const Grid<Dim>& grid_;
  const std::vector<Body<Dim>>& bodies_;
  BodyTreatment treatment_;
  FluidFraction fraction_at_;
  std::vector<double> constrained_depths_;  ///< `InnerWater`'s for each body in direct forcing, else 0 [m]
  std::vector<CutFace<Dim>> cuts_;
  // all null without bodies
  Fields fields_, resting_;  ///< fields of all bodies, and of those at rest; the latter null if all rest
  petsc::Vector solid_velocity_;
  petsc::Vector constraint_velocity_;  ///< velocity imposed on faces; null if it is the bodies' velocity [m/s]
  bool any_moves_, slides_ = false;
};

extern template class Mask<2>;
extern template class Mask<3>;

}  // namespace washfsi
