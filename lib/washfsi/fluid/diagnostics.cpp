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
      // a face in the boundary has half the volume of another
      const auto axis = static_cast<std::size_t>(d);
      const bool at_lower = !grid.periodic(d) && cell[axis] == 0;
      const bool at_upper = !grid.periodic(d) && cell[axis] == grid.cells()[axis] - 1;
      energy += (at_lower ? 0.25 : 0.5) * rho(cell, d) * lower * lower;
      if (at_upper) energy += 0.25 * rho(cell, d) * upper * upper;
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
