// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "washfsi/grid/stencils.hpp"

namespace washfsi {

// Inlined always and unrolled, as the grid's stencils are: left to itself the compiler does not unroll the advection,
// which then takes 15 times longer.

/// u_c midway between a c-face and the one before it along d: the mean, second order.
template <int Dim>
struct Mean {
  template <class Velocity>
  [[gnu::always_inline]] static inline double before(const Velocity& u, const Index<Dim>& face, int c, int d) {
    return 0.5 * (u(shifted<Dim>(face, d, -1), c) + u(face, c));
  }
};

/// The mean of two faces on either side, fourth order.
template <int Dim>
struct WideMean {
  template <class Velocity>
  [[gnu::always_inline]] static inline double before(const Velocity& u, const Index<Dim>& face, int c, int d) {
    return 1.125 * Mean<Dim>::before(u, face, c, d) -
           0.0625 * (u(shifted<Dim>(face, d, -2), c) + u(shifted<Dim>(face, d, 1), c));
  }
};

/// (u . grad u)_c on a c-face in flux form:
/// sum_d ( [u_d u_c](i + e_d / 2) - [u_d u_c](i - e_d / 2) ) / h_d
template <int Dim, class Velocity, class Flux>
[[gnu::always_inline]] inline double advection(const Velocity& u, const Index<Dim>& face, int c, const Spacing<Dim>& h,
                                               const Flux& flux) {
  double sum = 0;
#pragma GCC unroll 3
  for (int d = 0; d < Dim; ++d) {
    const Index<Dim> next = shifted<Dim>(face, d, 1), previous = shifted<Dim>(face, d, -1);
    const double upper = flux.carrier(u, next, c, d), lower = flux.carrier(u, face, c, d);
    sum += (upper * flux.carried(u, face, c, d, upper) - lower * flux.carried(u, previous, c, d, lower)) * h.inverse[d];
  }
  return sum;
}

/// The factors of the flux form: the carrier u_d before a d-face along c, and the carried u_c between a c-face and the
/// next one along d, both by one kind of mean. With the wide one the flux is of fourth order, which leaves only the
/// error of its difference, a third of that of the flux or less.
template <int Dim, template <int> class MeanOf = Mean>
struct CentralFlux {
  /// Whether the carried value is bounded by its neighbours.
  static constexpr bool is_bounded = false;
  /// Whether it applies to a c-face.
  [[gnu::always_inline]] inline bool departs(const Index<Dim>&, int) const { return true; }
  template <class Velocity>
  [[gnu::always_inline]] inline double carrier(const Velocity& u, const Index<Dim>& face, int c, int d) const {
    return MeanOf<Dim>::before(u, face, d, c);
  }
  template <class Velocity>
  [[gnu::always_inline]] inline double carried(const Velocity& u, const Index<Dim>& face, int c, int d, double) const {
    return MeanOf<Dim>::before(u, shifted<Dim>(face, d, 1), c, d);
  }
};

/// The carried value from upwind with van Leer's limiter (J. Comput. Phys. 14 (1974) 361): bounded by its neighbours,
/// second order where the flow is smooth.
template <int Dim>
struct UpwindFlux : CentralFlux<Dim> {
  static constexpr bool is_bounded = true;
  template <class Velocity>
  [[gnu::always_inline]] inline double carried(const Velocity& u, const Index<Dim>& face, int c, int d,
                                               double carrier) const {
    // both directions are evaluated and one is chosen, so that the compiler can work on many faces at once
    const Index<Dim> next = shifted<Dim>(face, d, 1);
    const double here = u(face, c), there = u(next, c), jump = there - here;
    const double behind = here - u(shifted<Dim>(face, d, -1), c), beyond = u(shifted<Dim>(next, d, 1), c) - there;
    const double side = carrier >= 0 ? behind : beyond, product = side * jump;
    // van Leer: half the harmonic mean of the slopes, 0 at an extremum
    const double step = (product > 0 ? product : 0) / (product > 0 ? side + jump : 1);
    return carrier >= 0 ? here + step : there - step;
  }
};

/// Blends the mean with the upwind value beside walls off the grid, face by face: variations within a cell at a wall
/// appear to the mean as short waves, which depend on where the wall lies in its cell.
template <int Dim, class Nearness>
struct WallsideFlux : CentralFlux<Dim> {
  const Nearness& near;  ///< share of upwind, from 0 to 1, on faces

  explicit WallsideFlux(const Nearness& of_faces) : near(of_faces) {}

  [[gnu::always_inline]] inline bool departs(const Index<Dim>& face, int c) const {
    double sum = near(face, c);
    for (int d = 0; d < Dim; ++d) sum += near(shifted<Dim>(face, d, 1), c) + near(shifted<Dim>(face, d, -1), c);
    return sum > 0;
  }
  template <class Velocity>
  [[gnu::always_inline]] inline double carried(const Velocity& u, const Index<Dim>& face, int c, int d,
                                               double carrier) const {
    const double mean = CentralFlux<Dim>::carried(u, face, c, d, carrier);
    const double part = std::max(near(face, c), near(shifted<Dim>(face, d, 1), c));
    return mean + part * (UpwindFlux<Dim>{}.carried(u, face, c, d, carrier) - mean);
  }
};

}  // namespace washfsi
