// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/diagnostics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "washfsi/fluid/stencils.hpp"

namespace washfsi {

namespace {

// 2 e:e summed over this rank's cells and, between two directions, over the edges where their faces meet; an edge in
// the boundary has half the volume of another. Where all faces are solid or beyond the box nothing is counted.
template <int Dim>
double squared_strain(const Grid<Dim>& grid, const ConstFaceView<Dim>& u, Vec fluid_fraction) {
  const petsc::LocalVector local_share(grid.face_dm());
  WASH_PETSC(VecZeroEntries(local_share));  // beyond the box all is solid
  WASH_PETSC(DMGlobalToLocal(grid.face_dm(), fluid_fraction, INSERT_VALUES, local_share));
  const ConstFaceView<Dim> share(grid.face_dm(), local_share);
  const Spacing<Dim> h(grid.spacing());
  std::array<bool, Dim> periodic{};
  for (std::size_t d = 0; d < Dim; ++d) periodic[d] = grid.periodic(static_cast<int>(d));
  const auto is_wet = [&](const Index<Dim>& face, int c) {
    const bool in_boundary = !periodic[static_cast<std::size_t>(c)] && face[static_cast<std::size_t>(c)] == 0;
    return !in_boundary && share(face, c) > 0;
  };
  double sum = 0;
  for (int c = 0; c < Dim; ++c) {
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
      const Index<Dim> next = shifted<Dim>(cell, c, 1);
      if (is_wet(cell, c) || is_wet(next, c)) sum += 2 * std::pow((u(next, c) - u(cell, c)) * h.inverse[c], 2);
    });
    for (int d = 0; d < c; ++d) {
      Box<Dim> edges = grid.owned();
      for (const int axis : {c, d}) {
        const auto a = static_cast<std::size_t>(axis);
        if (!grid.periodic(axis) && edges.upper[a] == grid.cells()[a]) ++edges.upper[a];
      }
      for_each<Dim>(edges, [&](const Index<Dim>& edge) {
        const Index<Dim> below = shifted<Dim>(edge, d, -1), beside = shifted<Dim>(edge, c, -1);
        if (!is_wet(edge, c) && !is_wet(below, c) && !is_wet(edge, d) && !is_wet(beside, d)) return;
        double volume = 1;
        for (const int axis : {c, d}) {
          const PetscInt place = edge[static_cast<std::size_t>(axis)];
          if (!grid.periodic(axis) && (place == 0 || place == grid.cells()[static_cast<std::size_t>(axis)]))
            volume *= 0.5;
        }
        const double shear = (u(edge, c) - u(below, c)) * h.inverse[d] + (u(edge, d) - u(beside, d)) * h.inverse[c];
        sum += volume * shear * shear;
      });
    }
  }
  return sum;
}

}  // namespace

template <int Dim>
FlowDiagnostics<Dim> FlowDiagnostics<Dim>::of(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                              const FlowState& state, double time, double dt) {
  FlowDiagnostics result;
  const petsc::LocalVector local(grid.face_dm(), state.velocity);
  boundary.fill(local, time);
  const ConstFaceView<Dim> u(grid.face_dm(), local), rho(grid.face_dm(), state.density);
  const ConstFaceView<Dim> share(grid.face_dm(), state.fluid_fraction ? state.fluid_fraction : state.density);
  const Spacing<Dim> h(grid.spacing());
  const Point<Dim> middle = 0.5 * (grid.lower() + grid.upper());
  double energy = 0, turning = 0;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    double courant = 0;
    for (int d = 0; d < Dim; ++d) {
      const double lower = u(cell, d), upper = u(shifted<Dim>(cell, d, 1), d);
      courant += dt * std::max(std::abs(lower), std::abs(upper)) * h.inverse[d];
      // a face in the boundary has half the volume of another
      const auto axis = static_cast<std::size_t>(d);
      const bool at_lower = !grid.periodic(d) && cell[axis] == 0;
      const bool at_upper = !grid.periodic(d) && cell[axis] == grid.cells()[axis] - 1;
      const double part = state.fluid_fraction ? share(cell, d) : 1;
      const double mass = part * rho(cell, d) * (at_lower ? 0.5 : 1);
      energy += 0.5 * mass * lower * lower;
      if (at_upper) energy += 0.25 * rho(cell, d) * upper * upper;
      if (d < 2) turning += (d == 0 ? -1 : 1) * mass * lower * (grid.face_center(cell, d) - middle)[1 - d];
    }
    if (!std::isfinite(courant)) courant = std::numeric_limits<double>::infinity();
    if (courant > result.courant.value) {
      result.courant.value = courant;
      const Point<Dim> place = grid.cell_center(cell);
      std::copy_n(place.data(), Dim, result.courant.place);
    }
    result.max_divergence = std::max(result.max_divergence, std::abs(divergence<Dim>(u, cell, h)));
  });
  const double strain =
      state.viscosity > 0 ? squared_strain(grid, u, state.fluid_fraction ? state.fluid_fraction : state.density) : 0;
  const std::vector<double> sums =
      ordered_sum(grid.comm(), std::vector<double>{energy, turning, state.viscosity * strain});
  result.kinetic_energy = sums[0] * grid.cell_volume();
  result.angular_momentum = sums[1] * grid.cell_volume();
  result.dissipation = sums[2] * grid.cell_volume();
  result.max_divergence = largest(grid.comm(), result.max_divergence);
  result.courant = largest(grid.comm(), result.courant);
  return result;
}

template struct FlowDiagnostics<2>;
template struct FlowDiagnostics<3>;

}  // namespace washfsi
