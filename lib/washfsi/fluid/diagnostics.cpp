// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/diagnostics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "washfsi/fluid/stencils.hpp"

namespace washfsi {

template <int Dim>
FlowDiagnostics<Dim> FlowDiagnostics<Dim>::of(const Grid<Dim>& grid, const Boundary<Dim>& boundary, Vec velocity,
                                              Vec density, double time, double dt) {
  FlowDiagnostics result;
  const petsc::LocalVector local(grid.face_dm(), velocity);
  boundary.fill(local, time);
  const ConstFaceView<Dim> u(grid.face_dm(), local), rho(grid.face_dm(), density);
  const Spacing<Dim> h(grid.spacing());
  double energy = 0;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    double courant = 0;
    for (int d = 0; d < Dim; ++d) {
      const double lower = u(cell, d), upper = u(shifted<Dim>(cell, d, 1), d);
      courant += dt * std::max(std::abs(lower), std::abs(upper)) * h.inverse[d];
      energy += 0.5 * rho(cell, d) * lower * lower;
    }
    if (!std::isfinite(courant)) courant = std::numeric_limits<double>::infinity();
    if (courant > result.courant.value) {
      result.courant.value = courant;
      const Point<Dim> place = grid.cell_center(cell);
      std::copy_n(place.data(), Dim, result.courant.place);
    }
    result.max_divergence = std::max(result.max_divergence, std::abs(divergence<Dim>(u, cell, h)));
  });
  result.kinetic_energy = ordered_sum(grid.comm(), energy * grid.cell_volume());
  result.max_divergence = largest(grid.comm(), result.max_divergence);
  result.courant = largest(grid.comm(), result.courant);
  return result;
}

template struct FlowDiagnostics<2>;
template struct FlowDiagnostics<3>;

}  // namespace washfsi
