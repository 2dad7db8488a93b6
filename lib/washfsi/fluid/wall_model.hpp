// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "washfsi/fluid/pure_liquid.hpp"
#include "washfsi/grid/boundary.hpp"
#include "washfsi/grid/cell_share.hpp"
#include "washfsi/support/options.hpp"
#include "washfsi/support/state_list.hpp"

namespace washfsi {

/// How the friction of the box's no-slip sides follows from the flow: from the difference to the first cell, or by the
/// law of a turbulent wall layer in equilibrium.
enum class WallTreatment { none, equilibrium };
const ChoiceNames<WallTreatment>& names_of(WallTreatment);

/// The friction of walls whose layers are thinner than a cell. With u the velocity relative to the wall, h the spacing
/// across it:
///   1. u_1, u_2   along the wall at the middles of the first and the second cell, filtered over T = y_2/|u_2|:
///                 u_bar += dt/(T + dt) (u - u_bar). T is chosen: longer times, as y_2/(0.41 u_tau), are less accurate
///                 in steady channels; the strokes of an agitator were not tried
///   2. u_tau      of Reichardt's law at y_2 = 3/2 h for |u_bar_2|: not at the first cell, whose velocity results from
///                 the stress of the wall (Kawai and Larsson, Phys. Fluids 24 (2012) 015105)
///   3. mu_w       = rho u_tau^2 (h/2)/|u_bar_1|: with it the discrete friction mu_w u_1/(h/2) has the mean rho
///                 u_tau^2. |u_bar_1| is taken as |u_bar_2|/3 at least, and mu_w is at least the viscosity of the
///                 liquid, as where profiles bend as in a wall layer
///   4. ghosts     beyond the side have such a viscosity that its mean with that of the cell is mu_w
/// So the implicit solution, the loads and the dissipation all have that friction. Where y_2+ <= 5 the layer is
/// resolved, and nothing is changed. The filter removes the correlation of stress and velocity in the first cell: Yang,
/// Park and Moin (Phys. Rev. Fluids 2 (2017) 104601).
template <int Dim>
class WallModel {
 public:
  WallModel(const Grid<Dim>& grid, const Boundary<Dim>& boundary);

  /// Steps 1 to 3, for a velocity [m/s] with one layer of ghosts, filled, dt [s] after the previous one. Where a cell
  /// has no share of fluid nothing is changed.
  void observe(const ConstFaceView<Dim>& velocity, double dt, const PureLiquid& liquid, const CellShare<Dim>& share);
  /// Step 4, for the viscosity in cells, local, its ghosts filled. Collective.
  void set_ghosts(Vec local_viscosity) const;

  /// Registers u_bar_1 and u_bar_2 in the first and the second cell from each side: in component `axis` of vector k the
  /// tangential velocity along axis + 1 + k. Without stored values the filter starts with the next flow.
  void register_state(StateList& state);

 private:
  using Tangential = Eigen::Matrix<double, Dim - 1, 1>;
  void observe_cell(const ConstFaceView<Dim>& u, const Index<Dim>& cell, int axis, int inwards, double dt,
                    const PureLiquid& liquid);
  Tangential filter(const Index<Dim>& cell, int axis, const Tangential& now, double weight);

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  std::array<petsc::Vector, Dim - 1> filtered_;
  petsc::Vector wall_viscosity_;  ///< mu_w in the first cell from a side across component's axis; 0 where unchanged
  bool begun_ = false;            ///< whether the filtered velocities are of an earlier flow
};

/// The largest y+ of the middles of the cells beside the box's no-slip walls, by the law at the second cells; the
/// velocity has one layer of ghosts, filled. 0 without such walls. Collective.
template <int Dim>
double largest_y_plus(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const ConstFaceView<Dim>& velocity,
                      const PureLiquid& liquid);

extern template class WallModel<2>;
extern template class WallModel<3>;

}  // namespace washfsi
