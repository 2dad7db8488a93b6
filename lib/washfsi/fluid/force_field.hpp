// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <petscvec.h>

namespace washfsi {

/// A force density on the water, evaluated as a step begins.
class ForceField {
 public:
  ForceField() = default;
  ForceField(const ForceField&) = delete;
  ForceField& operator=(const ForceField&) = delete;
  virtual ~ForceField() = default;

  /// Adds it to a force density on faces [N/m3]. Collective.
  virtual void add_to(Vec force) const = 0;
};

}  // namespace washfsi
