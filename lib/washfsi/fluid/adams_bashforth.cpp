// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/adams_bashforth.hpp"

namespace washfsi {

AdvectionWeights adams_bashforth(double bend, double dt, double before, double earlier) {
  if (before == 0) return {};
  const double line = 0.5 * dt / before;
  AdvectionWeights weights{1 + line, -line, 0};
  if (earlier == 0 || bend == 0) return weights;
  // mean over the step of s (s + before), times the second divided difference
  const double parabola = bend * dt * (dt / 3 + before / 2), both = before + earlier;
  weights.now += parabola / (before * both);
  weights.before -= parabola / (before * earlier);
  weights.earlier = parabola / (earlier * both);
  return weights;
}

}  // namespace washfsi
