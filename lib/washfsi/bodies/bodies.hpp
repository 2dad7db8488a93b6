// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "washfsi/fluid/options.hpp"
#include "washfsi/mask/mask.hpp"
#include "washfsi/wall_forces/water_step.hpp"

namespace washfsi {

/// The water in and after a step, as the loads on bodies follow from it.
struct WaterAtBodies {
  Vec constraint_force = nullptr;  ///< [N/m3] on faces; null without one
  Vec density = nullptr;           ///< [kg/m3] on faces
  Vec pressure = nullptr;          ///< [Pa]
  Vec local_velocity = nullptr;    ///< after the step, of face_dm, its ghosts filled [m/s]
  Viscosity viscosity;
  double time = 0, dt = 0;  ///< end and length of the step [s]
};

/// The rigid bodies in the water, by whichever method they act on it: a mask on the grid, and with direct forcing the
/// forces of markers on their walls, with a law of friction if there is one.
template <int Dim>
class Bodies {
 public:
  /// The list stays alive and as it is. Collective.
  Bodies(const Grid<Dim>& grid, Boundary<Dim>& boundary, const std::vector<Body<Dim>>& list,
         const BodyTreatment& treatment, const FluidOptions<Dim>& fluid);

  /// Places the bodies as they are at `time`, with the velocity of the water before the step [m/s], at its time.
  /// Collective.
  void place(double time, Vec velocity, double time_of_velocity);
  /// The same without water: as a run that goes on finds them. Collective.
  void place(double time);
  /// Lets the water slide where the wall law has its friction; call it before a step, after the law has seen the flow.
  /// Does nothing without a law. Collective.
  void let_water_slide();

  /// What they ask of the fluid's velocity; valid until they move.
  Constraint<Dim> constraint() const { return mask_.constraint(); }
  /// Their walls' forces with direct forcing, else null.
  WallForces<Dim>* wall_forces() { return walls_.get(); }
  const WallForces<Dim>* wall_forces() const { return walls_.get(); }
  /// The law of friction of their walls, null without one.
  BodyWallLaw<Dim>* wall_law() { return law_.get(); }
  const BodyWallLaw<Dim>* wall_law() const { return law_.get(); }
  /// The velocity u becomes H u + (1 - H) u_solid: what moves the markers of cloths. Collective.
  void apply(Vec velocity) const { mask_.apply(velocity); }

  /// H on faces; null without bodies.
  Vec fluid_fraction() const { return list_.empty() ? nullptr : mask_.fluid_fraction(); }
  /// The fluid volume fraction of faces; null without bodies.
  Vec fluid_share() const { return list_.empty() ? nullptr : mask_.fluid_share(); }
  /// The share of each face that the mean pressure gradient drives (`StepFields`); null where it drives all.
  Vec driven_share() const { return law_ ? mask_.fluid_share() : nullptr; }
  /// The weight of upwind advection on faces, 1 beside edges; null if advection is central everywhere.
  Vec upwind_weight() const { return walls_ ? walls_->upwind_weight() : nullptr; }
  /// Least H of faces that count as wet.
  double dry_fraction() const { return walls_ ? Mask<Dim>::fraction_half_a_cell_behind : 0; }

  /// What the water did to each body in a step, about its centre: by the constraint, at the feet of bodies that stand
  /// on sides of the box, and by the walls' forces. Collective.
  Loads<Dim> water_loads(const WaterAtBodies& water) const;
  /// What sides of the box took of the walls' forces, about the middle of the box. Collective.
  Loads<Dim> loads_on_sides(const std::vector<SideName>& sides) const;

  const Mask<Dim>& mask() const { return mask_; }
  /// Registers what goes on from step to step.
  void register_state(StateList& state);

 private:
  /// Counts thin parts along which the water slides as fluid in the mask; call it after mask and walls have been
  /// placed.
  void count_sliding_water();

  const Grid<Dim>& grid_;
  Boundary<Dim>& boundary_;
  const std::vector<Body<Dim>>& list_;
  Mask<Dim> mask_;
  std::unique_ptr<WallForces<Dim>> walls_;
  std::unique_ptr<BodyWallLaw<Dim>> law_;
};

extern template class Bodies<2>;
extern template class Bodies<3>;

}  // namespace washfsi
