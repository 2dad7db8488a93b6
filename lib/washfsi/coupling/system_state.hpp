// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// All that goes on from step to step in a system, which stays alive: each part registers its own.
template <int Dim>
StateList state_of(System<Dim>& system);

/// After the state has been put back: brings cloth, bodies and walls to their places. Collective.
template <int Dim>
void resume(System<Dim>& system);

/// Where a step starts, so that it can be taken again.
template <int Dim>
class SavedStart {
 public:
  /// Notes where the system stands; it stays alive. Collective.
  explicit SavedStart(System<Dim>& system);
  /// Puts it back there, after any number of steps. Collective.
  void restore() const;

 private:
  System<Dim>& system_;
  bool knows_cover_;
  StateCopy state_;
};

extern template class SavedStart<2>;
extern template class SavedStart<3>;

}  // namespace washfsi
