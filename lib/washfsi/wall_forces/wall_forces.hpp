// SPDX-License-Identifier: BSD-3-Clause
//
// Direct forcing: markers on the walls of bodies exert forces on the water, so that it does not slip along them. A step
//   1. begins with the forces of the step before, which turn with their body (`add_to` the explicit terms)
//   2. corrects most of the slip of the velocity before its projection (`reduce_slip`)
//   3. after the projection removes what is left beyond the tolerance (`enforce_no_slip`): first by a few slip
//   corrections,
//      each followed by a projection, then by the Krylov solver (`no_slip_solver.hpp`).
#pragma once

#include <optional>

#include "washfsi/fluid/force_field.hpp"
#include "washfsi/wall_forces/no_slip_solver.hpp"
#include "washfsi/wall_forces/recycled_directions.hpp"

namespace washfsi {

template <int Dim>
class WallForces : public ForceField {
 public:
  /// Collective. `density` [kg/m3] is the water's.
  WallForces(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const std::vector<Body<Dim>>& bodies,
             const BodyTreatment& treatment, double density);

  /// Places the markers as the bodies are at `time`. Collective.
  void place(double time);
  /// From the next trial on lets the water slide where a law of friction acts instead. It stays alive.
  void let_slide(const BodyWallLaw<Dim>& law) { markers_.let_slide(law); }

  /// For schemes that try a step several times: every trial begins with the forces of the step before, and `accept`
  /// makes those of the last trial its successors. The density [kg/m3], on faces, is the trial's.
  void begin_trial(const TimeStep& step, Vec density);
  /// Adds the forces with which the trial begins, and the friction of the law. Collective.
  void add_to(Vec force) const override;
  /// What a velocity is whose slip is to be reduced: it decides by how much a force is answered.
  enum class Velocity { predicted, projected };
  /// Before a projection: takes most of the slip away from a velocity on faces. Collective.
  void reduce_slip(Vec velocity, Velocity kind);
  /// Of the bodies with more slip than the tolerance: forces `relaxation` times as large as those that take it away
  /// without the pressure; false if there is no such body. Collective.
  bool reduce_slip_beyond_tolerance(Vec velocity, double relaxation);
  /// Makes the slip of the projected velocity as small as the tolerance at each body; it stays free of divergence.
  /// Collective. Errors: DivergedError.
  void enforce_no_slip(Vec velocity, Projection& projection);
  void accept();

  const WallMarkers<Dim>& markers() const { return markers_; }
  const Points<Dim>& forces() const {
    return forces_;
  }  ///< F of each patch of this rank [N; per unit depth in the plane]
  /// On faces: how near they are to edges where central advection is to give way; null if it is to nowhere.
  Vec limits_advection() const { return limits_advection_ ? markers_.nearness() : nullptr; }

  /// Registers the forces of the step before and the recycled directions. Other bodies begin without.
  void register_state(StateList& state);
  const Points<Dim>& previous() const { return previous_; }  ///< F of the step before, in the frames of the bodies

 private:
  void add_forces(const Points<Dim>& more, Vec velocity);
  Points<Dim> correction(const Points<Dim>& slips, double relaxation) const;
  Points<Dim> without(const std::vector<bool>& bodies, Points<Dim> values) const;
  void recycle_last_correction(const Points<Dim>& slips_after);

  WallMarkers<Dim> markers_;
  NoSlipSolver<Dim> solver_;
  RecycledDirections<Dim> recycled_;
  bool limits_advection_;
  Points<Dim> forces_, previous_;
  TimeStep step_;  ///< under way
  /// The last correction, before its response is known.
  struct Correction {
    Points<Dim> forces, slips;
  };
  std::optional<Correction> last_correction_;
};

extern template class WallForces<2>;
extern template class WallForces<3>;

}  // namespace washfsi
