// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/motion/body.hpp"

namespace washfsi {

/// Turns vectors from bodies' frames into space, or back, as the bodies are at `time`; body_of(n) is the nth's body.
template <int Dim, class BodyOf>
Points<Dim> turned(Points<Dim> values, const std::vector<Body<Dim>>& bodies, double time, bool into_space,
                   BodyOf&& body_of) {
  std::vector<Pose<Dim>> turns;
  for (const auto& body : bodies) turns.push_back(Pose<Dim>::at(Point<Dim>::Zero(), body.motion.angle(time)));
  for (std::size_t n = 0; n < values.size(); ++n) {
    const Pose<Dim>& turn = turns[body_of(n)];
    values[n] = into_space ? turn.in_space(values[n]) : turn.in_body_frame(values[n]);
  }
  return values;
}

}  // namespace washfsi
