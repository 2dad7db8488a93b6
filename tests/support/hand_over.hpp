// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "washfsi/support/state_list.hpp"

namespace washfsi::test {

/// Gives the state of one thing to another of its kind, as a restart does.
template <class Thing>
void hand_over(Thing& from, Thing& into) {
  StateList old_state, new_state;
  from.register_state(old_state);
  into.register_state(new_state);
  ASSERT_EQ(old_state.entries().size(), new_state.entries().size());
  for (std::size_t n = 0; n < new_state.entries().size(); ++n) {
    EXPECT_EQ(old_state.entries()[n].name, new_state.entries()[n].name);
    new_state.entries()[n].set(old_state.entries()[n].get());
  }
}

}  // namespace washfsi::test
