// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/coupling/system.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// Registers all state that a system carries from step to step, each part its own. The system stays alive.
template <int Dim>
void register_state(System<Dim>& system, StateList& list);

/// Brings cloth, bodies and walls to their places after the state has been restored. Collective.
template <int Dim>
void resume(System<Dim>& system);

/// A copy of the state at a step's start, so that the step can be repeated.
template <int Dim>
class SavedStart {
 public:
  /// Saves the state of the system, which stays alive. Collective.
  explicit SavedStart(System<Dim>& system);
  /// Restores that state, after any number of steps. Collective.
  void restore() const;

 private:
  System<Dim>& system_;
  bool knows_cover_;
  StateCopy state_;
};

extern template class SavedStart<2>;
extern template class SavedStart<3>;

}  // namespace washfsi
