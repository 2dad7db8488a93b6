// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <petscvec.h>

#include "washfsi/fluid/wall_model.hpp"

namespace washfsi {

/// The flow that a step begins with.
struct StepFlow {
  Vec velocity = nullptr;     ///< [m/s]
  double time = 0;            ///< [s]
  Vec fluid_share = nullptr;  ///< the share of each face that lies in fluid; none: all of it
  double last_step = 0;       ///< the length of the step before [s]; 0: there was none
};

/// Walls within the water whose friction follows from the viscosity of the water beside them.
class WallViscosity {
 public:
  WallViscosity() = default;
  WallViscosity(const WallViscosity&) = delete;
  WallViscosity& operator=(const WallViscosity&) = delete;
  virtual ~WallViscosity() = default;

  /// Takes the flow, once a step. Collective.
  virtual void observe(const StepFlow& flow, const PureLiquid& liquid) = 0;
  /// Makes the viscosity [Pa s] of this rank's cells beside and behind the walls such that it gives their friction. May
  /// be repeated. Collective.
  virtual void replace(Vec viscosity) const = 0;
};

}  // namespace washfsi
