// SPDX-License-Identifier: BSD-3-Clause
//
// One step of the water between bodies' walls: the only place that sets the order of the fluid's phases and the walls'
// forces. Couplings that add forces of the cloth at the end of the step call
//   predict, project, any number of (add_force, enforce_no_slip), finish,
// all others
//   predict, correct_slip_and_project, enforce_no_slip, finish,
// which `advance` does at once.
#pragma once

#include "washfsi/fluid/fractional_step.hpp"
#include "washfsi/wall_forces/wall_forces.hpp"

namespace washfsi {

template <int Dim>
class WaterStep {
 public:
  /// `walls` is null without direct forcing. Both stay alive.
  WaterStep(FractionalStep<Dim>& fluid, WallForces<Dim>* walls) : fluid_(fluid), walls_(walls) {}

  /// Phases 1 and 2 of `fractional_step.hpp`, with the walls' forces of the previous step. Collective.
  void predict(const TimeStep& step, StepFields<Dim> fields);
  /// Phase 3 without a slip correction, for steps in which `add_force` follows, which corrects the slip. Collective.
  void project() { fluid_.projection().project(); }
  /// Corrects the slip of the intermediate velocity, then projects it (phase 3). Collective.
  void correct_slip_and_project();
  /// Phase 3b: adds a further force density on faces to the projected velocity, reduces its slip and projects it again.
  /// Collective.
  void add_force(Vec force);
  /// Reduces the filtered slip to the tolerance. Collective. Errors: DivergedError.
  void enforce_no_slip();
  /// Phase 4: the step's velocity and the walls' forces become those of the previous step. Collective.
  void finish();

  /// Takes a whole step without further forces. Collective. Errors: DivergedError.
  void advance(const TimeStep& step, const StepFields<Dim>& fields);

 private:
  FractionalStep<Dim>& fluid_;
  WallForces<Dim>* walls_;
};

extern template class WaterStep<2>;
extern template class WaterStep<3>;

}  // namespace washfsi
