// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/diagnostics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "washfsi/grid/strain_rate.hpp"

namespace washfsi {

namespace {

/// A copy of the grid's data for the sums, so that the compiler sees that it does not change.
template <int Dim>
struct Ends {
  explicit Ends(const Grid<Dim>& grid) : cells(grid.cells()) {
    for (int d = 0; d < Dim; ++d) periodic[d] = grid.periodic(d);
  }
  /// Whether a face or edge with this number along an axis lies in the boundary.
  bool at_lower(const Index<Dim>& index, std::size_t axis) const { return !periodic[axis] && index[axis] == 0; }
  bool at_upper(const Index<Dim>& index, std::size_t axis) const {
    return !periodic[axis] && index[axis] == cells[axis];
  }
  /// Whether a face has a number in the box.
  bool within(const Index<Dim>& index) const {
    for (int d = 0; d < Dim; ++d)
      if (!periodic[d] && (index[d] < 0 || index[d] >= cells[d])) return false;
    return true;
  }
  /// A box of cells, extended by the faces or edges in the upper side of an axis.
  Box<Dim> with_upper(Box<Dim> box, std::size_t axis) const {
    if (!periodic[axis] && box.upper[axis] == cells[axis]) ++box.upper[axis];
    return box;
  }
  /// Volume of a face or edge: half in the boundary.
  double part(const Index<Dim>& index, std::size_t axis) const {
    return at_lower(index, axis) || at_upper(index, axis) ? 0.5 : 1;
  }

  Index<Dim> cells;
  std::array<bool, Dim> periodic;
};

// 2 mu e:e over the viscosity's scale, summed over this rank's cells and, between two directions, over the edges where
// their faces meet. Cells and edges without a wet face do not count.
template <int Dim, class Form, class IsWet>
double squared_strain(const Grid<Dim>& grid, const ConstFaceView<Dim>& u, const Form& mu, const Ends<Dim>& ends,
                      const IsWet& is_wet) {
  const Spacing<Dim> h(grid.spacing());
  double sum = 0;
  const auto add_stretching = [&](const Index<Dim>& cell, auto c) {
    const Index<Dim> next = shifted<Dim>(cell, c, 1);
    const double rate = stretching<Dim>(u, cell, c, h);
    if (is_wet(cell, c) || is_wet(next, c)) sum += mu.in_cell(cell) * 2 * rate * rate;
  };
  const auto add_shear = [&](const Index<Dim>& edge, auto c, auto d) {
    const Index<Dim> below = shifted<Dim>(edge, d, -1), beside = shifted<Dim>(edge, c, -1);
    if (!is_wet(edge, c) && !is_wet(below, c) && !is_wet(edge, d) && !is_wet(beside, d)) return;
    const double rate = shear_rate<Dim>(u, edge, c, d, h);
    sum += mu.on_edge(edge, c, d) * ends.part(edge, c) * ends.part(edge, d) * rate * rate;
  };
  Box<Dim> all = grid.owned();
  for (std::size_t d = 0; d < Dim; ++d) all = ends.with_upper(all, d);
  for_each_row<Dim>(all, [&](const Box<Dim>& row) {
    for_each_component<Dim>([&](auto c) {
      for_each<Dim>(grid.owned().common(row), [&](const Index<Dim>& cell) { add_stretching(cell, c); });
      for_each_component<Dim>([&](auto d) {
        if constexpr (d < c) {
          const Box<Dim> edges = ends.with_upper(ends.with_upper(grid.owned(), c), d);
          for_each<Dim>(edges.common(row), [&](const Index<Dim>& edge) { add_shear(edge, c, d); });
        }
      });
    });
  });
  return sum;
}

// This rank's part of the dissipation over the volume of a cell. Faces in solids, in the box's sides and beyond them
// are not wet.
template <int Dim>
double dissipated(const Grid<Dim>& grid, const ConstFaceView<Dim>& u, const FlowState& state) {
  if (state.liquid.viscosity.everywhere == 0 && !state.liquid.viscosity.in_cells) return 0;
  const Ends<Dim> ends(grid);
  double result = 0;
  with_viscosity<Dim>(grid, state.liquid.viscosity, [&](const auto& viscosity) {
    const auto sum_over = [&](const auto& is_wet) {
      result = viscosity.scale * squared_strain(grid, u, viscosity, ends, is_wet);
    };
    if (!state.fluid_fraction) {
      sum_over([&](const Index<Dim>& face, auto c) { return ends.within(face) && !ends.at_lower(face, c); });
      return;
    }
    const petsc::LocalVector local(grid.face_dm());
    WASH_PETSC(VecZeroEntries(local));  // beyond the box all is solid
    WASH_PETSC(DMGlobalToLocal(grid.face_dm(), state.fluid_fraction, INSERT_VALUES, local));
    const ConstFaceView<Dim> fraction(grid.face_dm(), local);
    sum_over([&](const Index<Dim>& face, auto c) {
      return !ends.at_lower(face, c) && fraction(face, c) > state.dry_fraction;
    });
  });
  return result;
}

}  // namespace

template <int Dim>
FlowDiagnostics<Dim> FlowDiagnostics<Dim>::of(const Grid<Dim>& grid, const FlowState& state, double dt) {
  FlowDiagnostics result;
  const Vec density = state.liquid.density;
  const ConstFaceView<Dim> u(grid.face_dm(), state.velocity), rho(grid.face_dm(), density);
  const ConstFaceView<Dim> fraction(grid.face_dm(), state.fluid_fraction ? state.fluid_fraction : density);
  const Spacing<Dim> h(grid.spacing());
  const Ends<Dim> ends(grid);
  const bool has_solids = state.fluid_fraction;
  const Point<Dim> middle = 0.5 * (grid.lower() + grid.upper());
  double energy = 0, turning = 0;
  for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
    double courant = 0;
    for_each_component<Dim>([&](auto d) {
      const Index<Dim> next = shifted<Dim>(cell, d, 1);
      const double lower = u(cell, d), upper = u(next, d);
      courant += dt * std::max(std::abs(lower), std::abs(upper)) * h.inverse[d];
      const double H = has_solids ? fraction(cell, d) : 1, part = ends.at_lower(cell, d) ? 0.5 : 1;
      const double momentum = part * H * rho(cell, d) * lower;
      energy += 0.5 * momentum * lower;
      if (ends.at_upper(next, d)) energy += 0.25 * rho(cell, d) * upper * upper;
      if constexpr (d < 2) turning += (d == 0 ? -1 : 1) * momentum * (grid.face_center(cell, d) - middle)[1 - d];
    });
    if (!std::isfinite(courant)) courant = std::numeric_limits<double>::infinity();
    if (courant > result.courant.value) {
      result.courant.value = courant;
      const Point<Dim> place = grid.cell_center(cell);
      std::copy_n(place.data(), Dim, result.courant.place);
    }
    result.max_divergence = std::max(result.max_divergence, std::abs(divergence<Dim>(u, cell, h)));
  });
  const std::vector<double> sums =
      ordered_sum(grid.comm(), std::vector<double>{energy, turning, dissipated(grid, u, state)});
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
