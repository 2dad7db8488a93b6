// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <petscvec.h>

#include "washfsi/fluid/wall_model.hpp"

namespace washfsi {

/// The flow at the start of a step.
struct StepFlow {
  Vec velocity = nullptr;     ///< velocity on faces [m/s]
  double time = 0;            ///< time [s]
  Vec fluid_share = nullptr;  ///< the share of each face that lies in fluid; null: all of it
  double last_step = 0;       ///< the length of the previous step [s]; 0: there was none
};

/// Walls within the water whose friction follows from the viscosity of the water beside them.
class WallViscosity {
 public:
  WallViscosity() = default;
  WallViscosity(const WallViscosity&) = delete;
  WallViscosity& operator=(const WallViscosity&) = delete;
  virtual ~WallViscosity() = default;

  /// Updates the friction from the flow, once a step. Collective.
  virtual void observe(const StepFlow& flow, const PureLiquid& liquid) = 0;
  /// Sets the viscosity [Pa s] of this rank's cells beside and behind the walls so that it gives their friction. May be
  /// repeated. Collective.
  virtual void replace(Vec viscosity) const = 0;
};

}  // namespace washfsi
