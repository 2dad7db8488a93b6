// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

/// The weights in a step of the advection terms at its start and at the starts of the two previous steps.
struct AdvectionWeights {
  double now = 1, before = 0, earlier = 0;
};

/// Weights for steps of dt, `before` and `earlier` [s], the latter two 0 if there were none: the mean over the step of
/// the line through the last two terms, as in Adams-Bashforth (3/2, -1/2 for equal steps), plus `bend` times the mean
/// of the parabola's departure from it. With bend = 0 waves grow by (w dt)^4/4 a step, with 1 they decay by 3/8 (w
/// dt)^4, up to w dt = 0.72; with 2/3 by (w dt)^4/6, up to 0.79, nearly the longest possible, and a third of the error
/// of bend = 0 is left.
AdvectionWeights adams_bashforth(double bend, double dt, double before, double earlier);

}  // namespace washfsi
