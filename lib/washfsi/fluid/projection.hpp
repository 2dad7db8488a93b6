// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <petscvec.h>

namespace washfsi {

/// The projection of the current step, for constraints that are solved for together with the pressure.
class Projection {
 public:
  Projection() = default;
  Projection(const Projection&) = delete;
  Projection& operator=(const Projection&) = delete;
  virtual ~Projection() = default;

  /// Makes the step's velocity divergence free again after a further force has changed it, and updates the pressure.
  /// Collective.
  virtual void project_again() = 0;
  /// Makes an increment of that velocity, zero at the sides of the box, divergence free, to a looser tolerance, since
  /// `project_again` follows. Does not change the pressure. Collective.
  virtual void project_increment(Vec increment) = 0;
};

}  // namespace washfsi
