// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/schedule.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/collective.hpp"

namespace washfsi {

bool Schedule::due(double interval, double time) const {
  const double now = time / interval, before = (time - state_.dt) / interval;
  return std::floor(now + 1e-6) > std::floor(before + 1e-6);
}

bool Schedule::measures_all(const Clock& after) const {
  return run_.history_interval == 0 || due(run_.history_interval, after.time) || ends(after, state_.steps_at_rest + 1);
}

bool Schedule::ends(const Clock& now, int steps_at_rest) const {
  const bool enough_steps = run_.max_steps > 0 && steps_taken(now) >= run_.max_steps;
  constexpr int steps_of_rest = 10;
  return enough_steps || steps_at_rest >= steps_of_rest || now.time >= run_.time_end - 1e-6 * state_.dt;
}

template <int Dim>
void Schedule::watch_rest(const System<Dim>& system) {
  if (run_.rest_speed == 0) return;
  int& steps = state_.steps_at_rest;
  double fastest = 0;
  for (const auto& velocity : system.state.velocities) fastest = std::max(fastest, velocity.norm());
  fastest *= 1 + system.step.cloth_slip;  // so that the water round them rests too
  if (largest(system.model.grid.comm(), fastest) >= run_.rest_speed)
    steps = 0;
  else if (steps != RunState::not_moved)
    ++steps;
}

template void Schedule::watch_rest<2>(const System<2>&);
template void Schedule::watch_rest<3>(const System<3>&);

}  // namespace washfsi
