// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

/// One step of time, from t^n to t^(n+1) [s].
struct TimeStep {
  double start = 0, dt = 0;

  double end() const { return start + dt; }
};

/// The time of a run, and the number of its steps.
struct Clock {
  double time = 0;  ///< t^n [s]
  long step = 0;    ///< n

  TimeStep next(double dt) const { return {time, dt}; }
  void advance(double dt) {
    time += dt;
    ++step;
  }
};

}  // namespace washfsi
