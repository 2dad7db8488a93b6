// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/view.hpp"
#include "washfsi/support/point.hpp"

namespace washfsi {

/// div u in a cell: sum_d ( u_d(i + e_d) - u_d(i) ) / h_d   [1/s]
template <int Dim, class Velocity>
double divergence(const Velocity& u, const Index<Dim>& cell, const Point<Dim>& h) {
  double sum = 0;
  for (int d = 0; d < Dim; ++d) sum += (u(shifted<Dim>(cell, d, 1), d) - u(cell, d)) / h[d];
  return sum;
}

/// d p / d x_d on the lower d-face of a cell: ( p(i) - p(i - e_d) ) / h_d
template <int Dim, class Pressure>
double gradient(const Pressure& p, const Index<Dim>& face, int d, const Point<Dim>& h) {
  return (p(face) - p(shifted<Dim>(face, d, -1))) / h[d];
}

/// lap u_c on a c-face: sum_d ( u_c(i + e_d) - 2 u_c(i) + u_c(i - e_d) ) / h_d^2
template <int Dim, class Velocity>
double laplacian(const Velocity& u, const Index<Dim>& face, int c, const Point<Dim>& h) {
  double sum = 0;
  for (int d = 0; d < Dim; ++d)
    sum += (u(shifted<Dim>(face, d, 1), c) - 2 * u(face, c) + u(shifted<Dim>(face, d, -1), c)) / (h[d] * h[d]);
  return sum;
}

/// (u . grad u)_c on a c-face in flux form with midpoint means, second order:
/// sum_d ( [u_d u_c](i + e_d / 2) - [u_d u_c](i - e_d / 2) ) / h_d
template <int Dim, class Velocity>
double advection(const Velocity& u, const Index<Dim>& face, int c, const Point<Dim>& h) {
  double sum = 0;
  for (int d = 0; d < Dim; ++d) {
    const Index<Dim> next = shifted<Dim>(face, d, 1), previous = shifted<Dim>(face, d, -1);
    // carrier u_d at the two ends of the momentum cell: a mean along c of the d-faces there
    const double upper_carrier = 0.5 * (u(next, d) + u(shifted<Dim>(next, c, -1), d));
    const double lower_carrier =
        d == c ? 0.5 * (u(face, d) + u(previous, d)) : 0.5 * (u(face, d) + u(shifted<Dim>(face, c, -1), d));
    sum += (upper_carrier * (u(next, c) + u(face, c)) - lower_carrier * (u(face, c) + u(previous, c))) / (2 * h[d]);
  }
  return sum;
}

}  // namespace washfsi
