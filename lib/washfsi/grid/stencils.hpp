// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/view.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// The grid's spacing as the stencils use it. Kernels have a local copy: the compiler cannot know that their stores do
/// not change the grid's, and would divide again for every face.
template <int Dim>
struct Spacing {
  explicit Spacing(const Point<Dim>& h) : inverse(h.cwiseInverse()), inverse_square(inverse.cwiseProduct(inverse)) {}
  Point<Dim> inverse, inverse_square;  ///< 1/h_d, 1/h_d^2
};

// The stencils are inlined always and their loops unrolled: component and direction then are constants and all indices
// fold into fixed offsets.

/// div u in a cell: sum_d ( u_d(i + e_d) - u_d(i) ) / h_d   [1/s]
template <int Dim, class Velocity>
[[gnu::always_inline]] inline double divergence(const Velocity& u, const Index<Dim>& cell, const Spacing<Dim>& h) {
  double sum = 0;
#pragma GCC unroll 3
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
#pragma GCC unroll 3
  for (int d = 0; d < Dim; ++d)
    sum += (u(shifted<Dim>(face, d, 1), c) - 2 * u(face, c) + u(shifted<Dim>(face, d, -1), c)) * h.inverse_square[d];
  return sum;
}

}  // namespace washfsi
