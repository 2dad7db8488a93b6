// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <petscvec.h>

namespace washfsi {

/// The projection of the step under way, for constraints that are solved for together with the pressure.
class Projection {
 public:
  Projection() = default;
  Projection(const Projection&) = delete;
  Projection& operator=(const Projection&) = delete;
  virtual ~Projection() = default;

  /// After a further force has changed the step's velocity: makes it free of divergence again and adds to the pressure
  /// what that takes. Collective.
  virtual void project_again() = 0;
  /// Makes an increment of that velocity, which is zero at the sides of the box, free of divergence; the pressure stays
  /// as it is. To a looser tolerance, since `project_again` follows. Collective.
  virtual void project_increment(Vec increment) = 0;
};

}  // namespace washfsi
