// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/view.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// The grid's spacing as the stencils use it. Kernels keep a copy of their own: the compiler cannot know that what they
/// write does not change the grid's, and would divide anew for every face.
template <int Dim>
struct Spacing {
  explicit Spacing(const Point<Dim>& h) : inverse(h.cwiseInverse()), inverse_square(inverse.cwiseProduct(inverse)) {}
  Point<Dim> inverse, inverse_square;  ///< 1/h_d, 1/h_d^2
};

// The stencils are inlined always: component and direction then are constants and all indices fold into fixed offsets.

/// div u in a cell: sum_d ( u_d(i + e_d) - u_d(i) ) / h_d   [1/s]
template <int Dim, class Velocity>
[[gnu::always_inline]] inline double divergence(const Velocity& u, const Index<Dim>& cell, const Spacing<Dim>& h) {
  double sum = 0;
  for (int d = 0; d < Dim; ++d) sum += (u(shifted<Dim>(cell, d, 1), d) - u(cell, d)) * h.inverse[d];
  return sum;
}

/// d p / d x_d on the lower d-face of a cell: ( p(i) - p(i - e_d) ) / h_d
template <int Dim, class Pressure>
[[gnu::always_inline]] inline double gradient(const Pressure& p, const Index<Dim>& face, int d, const Spacing<Dim>& h) {
  return (p(face) - p(shifted<Dim>(face, d, -1))) * h.inverse[d];
}

/// lap u_c on a c-face: sum_d ( u_c(i + e_d) - 2 u_c(i) + u_c(i - e_d) ) / h_d^2
template <int Dim, class Velocity>
[[gnu::always_inline]] inline double laplacian(const Velocity& u, const Index<Dim>& face, int c,
                                               const Spacing<Dim>& h) {
  double sum = 0;
  for (int d = 0; d < Dim; ++d)
    sum += (u(shifted<Dim>(face, d, 1), c) - 2 * u(face, c) + u(shifted<Dim>(face, d, -1), c)) * h.inverse_square[d];
  return sum;
}

/// u_c midway between a c-face and the next one along d: the mean, second order.
template <int Dim>
struct CentralValue {
  template <class Velocity>
  [[gnu::always_inline]] inline double operator()(const Velocity& u, const Index<Dim>& face, int c, int d,
                                                  double) const {
    return 0.5 * (u(face, c) + u(shifted<Dim>(face, d, 1), c));
  }
};

/// The same, taken from upwind with van Leer's limiter (J. Comput. Phys. 14 (1974) 361): bounded by its neighbours,
/// second order where the flow is smooth.
template <int Dim>
struct UpwindValue {
  template <class Velocity>
  [[gnu::always_inline]] inline double operator()(const Velocity& u, const Index<Dim>& face, int c, int d,
                                                  double carrier) const {
    const int step = carrier >= 0 ? 1 : -1;
    const Index<Dim> here = carrier >= 0 ? face : shifted<Dim>(face, d, 1);
    const double behind = u(here, c) - u(shifted<Dim>(here, d, -step), c);
    const double ahead = u(shifted<Dim>(here, d, step), c) - u(here, c);
    return u(here, c) + (behind * ahead > 0 ? behind * ahead / (behind + ahead) : 0);
  }
};

/// (u . grad u)_c on a c-face in flux form, the carrier u_d a mean along c:
/// sum_d ( [u_d u_c](i + e_d / 2) - [u_d u_c](i - e_d / 2) ) / h_d
template <int Dim, class Velocity, class Value>
[[gnu::always_inline]] inline double advection(const Velocity& u, const Index<Dim>& face, int c, const Spacing<Dim>& h,
                                               const Value& value) {
  double sum = 0;
  for (int d = 0; d < Dim; ++d) {
    const Index<Dim> next = shifted<Dim>(face, d, 1), previous = shifted<Dim>(face, d, -1);
    const double upper = 0.5 * (u(next, d) + u(shifted<Dim>(next, c, -1), d));
    const double lower = 0.5 * (u(face, d) + u(shifted<Dim>(face, c, -1), d));
    sum += (upper * value(u, face, c, d, upper) - lower * value(u, previous, c, d, lower)) * h.inverse[d];
  }
  return sum;
}

}  // namespace washfsi
