// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include <petscvec.h>

#include "washfsi/support/clock.hpp"

namespace washfsi {

/// Walls within the water that hold it by forces: no slip is one more constraint beside the divergence, and these
/// forces are to it what the pressure is to the other. As with the pressure, a step starts with those of the step
/// before and adds what they lack.
class WallForces {
 public:
  /// Makes an increment of the velocity free of divergence.
  using Project = std::function<void(Vec increment)>;

  WallForces() = default;
  WallForces(const WallForces&) = delete;
  WallForces& operator=(const WallForces&) = delete;
  virtual ~WallForces() = default;

  /// force += the density [N/m3] of the forces of the step before. Collective.
  virtual void add_held(Vec force) = 0;
  /// Removes most of the slip of a velocity on faces, as if there were no pressure; that times `relaxation`.
  /// Collective.
  virtual void push(Vec velocity, double relaxation) = 0;
  /// The same of the walls at which the slip is above its tolerance; false if it is at none.
  /// Collective.
  virtual bool push_unheld(Vec velocity, double relaxation) = 0;
  /// Adds to a velocity what, once projected, leaves a slip within its tolerance; false if there is nothing to add.
  /// Collective.
  virtual bool hold(const Project& project, Vec velocity) = 0;
  /// For schemes that try a step several times: every trial starts with the forces of the step before. `accept` makes
  /// those of the last trial its successors. The density [kg/m3], on faces, is the trial's.
  virtual void begin_trial(const TimeStep& step, Vec density) = 0;
  virtual void accept() = 0;
};

}  // namespace washfsi
