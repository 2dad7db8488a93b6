// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace washfsi {

/// The weights in a step of the advection terms at its start and at the starts of the two previous steps.
struct AdvectionWeights {
  double now = 1, before = 0, earlier = 0;
};

/// Weights for steps of dt, `before` and `earlier` [s], the latter two 0 if there were none. They are the mean over the
/// step of the line through the last two terms, as in Adams-Bashforth: 1 + chi/2 and -chi/2 with chi = dt/`before`. To
/// this is added the share `bend`, w_3 of the theory, of the mean by which the parabola through three terms departs
/// from the line. A wave of frequency omega grows by (1/4 - 5/8 w_3) (omega dt)^4 in each step. So with w_3 = 0 waves
/// grow, with 1 they decay, up to omega dt = 0.72, and with 2/3 they decay by (omega dt)^4/6, up to 0.79, which is
/// nearly the longest possible. Then a third of the phase error of w_3 = 0 is left.
AdvectionWeights adams_bashforth(double bend, double dt, double before, double earlier);

}  // namespace washfsi
