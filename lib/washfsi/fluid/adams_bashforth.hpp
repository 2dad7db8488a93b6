// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

/// What the advection terms at a step's start and at the starts of the two steps before weigh in it.
struct AdvectionWeights {
  double now = 1, before = 0, earlier = 0;
};

/// Of steps of dt, `before` and `earlier` [s], the latter two 0 if there were none: the integral over the step of the
/// line through the last two terms, as Adams and Bashforth take it (3/2, -1/2 for equal steps), and `bend` times that
/// of the parabola beyond it. With bend = 0 waves grow by (w dt)^4/4 a step, with 1 they decay by 3/8 (w dt)^4, up to
/// w dt = 0.72; with 2/3 by a sixth, up to 0.79, about the longest that there is, and a third of the error of 0 is
/// left.
AdvectionWeights adams_bashforth(double bend, double dt, double before, double earlier);

}  // namespace washfsi
