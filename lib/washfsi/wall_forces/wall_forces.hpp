// SPDX-License-Identifier: BSD-3-Clause
//
// Direct forcing: markers on the walls of bodies exert forces on the water, so that it does not slip along them. A step
//   1. begins with the forces of the previous step, which turn with their body (`add_to` the explicit terms)
//   2. corrects most of the slip before the last projection (`reduce_slip`)
//   3. after the projection removes the slip beyond the tolerance (`enforce_no_slip`): first by a few slip
//      corrections, each followed by a projection, then by the Krylov solver (`no_slip_solver.hpp`).
#pragma once

#include "washfsi/fluid/force_field.hpp"
#include "washfsi/wall_forces/no_slip_solver.hpp"

namespace washfsi {

template <int Dim>
class WallForces : public ForceField {
 public:
  /// Collective.
  WallForces(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
             const BodyTreatment& treatment);

  /// Places the markers as the bodies are at `time`. Collective.
  void place(double time);
  /// From the next trial on, lets the water slide where this law of friction acts instead of no slip. `law` stays
  /// alive.
  void let_slide(const BodyWallLaw<Dim>& law) { markers_.sliding().let_slide(law); }

  /// Begins a trial of a step, which schemes may repeat: each trial starts from the forces of the previous step, and
  /// `accept` keeps those of the last trial for the next step. `density` [kg/m3], on faces, is the trial's. Collective.
  void begin_trial(const TimeStep& step, Vec density);
  /// Adds the forces at the start of the trial, and the friction of the law. Collective.
  void add_to(Vec force) const override;
  /// Whether the velocity whose slip is reduced has been projected yet; the response to a force differs.
  enum class Stage { predicted, projected };
  /// Removes most of the slip from a velocity on faces; call it before a projection. Collective.
  void reduce_slip(Vec velocity, Stage stage);
  /// Applies one slip correction, without regard to the pressure and times `relaxation`, to each body whose filtered
  /// slip is above the tolerance; false if there is no such body. Collective.
  bool reduce_slip_beyond_tolerance(Vec velocity, double relaxation);
  /// Reduces the filtered slip of the projected velocity to the tolerance at each body and keeps it free of divergence.
  /// Collective. Errors: DivergedError.
  void enforce_no_slip(Vec velocity, Projection& projection);
  /// Makes the forces of the last trial those of the previous step.
  void accept();

  const WallMarkers<Dim>& markers() const { return markers_; }
  /// F of each patch of this rank [N; per unit depth in the plane].
  const Points<Dim>& forces() const { return forces_; }
  /// Nearness of faces to edges beside which central advection is limited, from 0 to 1; null if it is limited nowhere.
  Vec upwind_weight() const { return limits_advection_ ? markers_.nearness() : nullptr; }

  /// Registers the forces of the previous step. A restart whose patches differ in number begins with zero forces.
  void register_state(StateList& state);
  const Points<Dim>& previous() const { return previous_; }  ///< F of the previous step, in the frames of the bodies

 private:
  void add_forces(const Points<Dim>& more, Vec velocity);
  Points<Dim> without(const std::vector<bool>& bodies, Points<Dim> values) const;

  WallMarkers<Dim> markers_;
  NoSlipSolver<Dim> solver_;
  bool limits_advection_;
  Points<Dim> forces_, previous_;
};

extern template class WallForces<2>;
extern template class WallForces<3>;

}  // namespace washfsi
