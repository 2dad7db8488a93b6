// SPDX-License-Identifier: BSD-3-Clause
//
// Spread and interpolate, thesis (3.2-11 .. 3.2-14), on the faces of the staggered grid:
//   f(x) = sum_k F_k delta(x - X_k)                 spread S
//   U_k  = sum_x u(x) delta(x - X_k) dx             interpolate J, with dx the volume of a cell
// With equal widths each is the other's adjoint, also at sides of the box: J reads ghosts that mirror the interior, S
// adds what falls on ghosts back with the same signs; the rest is the side's reaction.
#pragma once

#include <array>
#include <optional>

#include "washfsi/grid/boundary.hpp"
#include "washfsi/immersed_boundary/face_stencils.hpp"
#include "washfsi/immersed_boundary/marker_exchange.hpp"

namespace washfsi {

template <int Dim>
class Transfer {
 public:
  Transfer(const Grid<Dim>& grid, const Boundary<Dim>& boundary, const DeltaOptions& delta);

  const DeltaOptions& delta() const { return delta_; }

  /// Collective. Errors: DivergedError if a marker has left the box.
  void check_inside(const Points<Dim>& positions) const;

  /// Fixes S and J at these marker positions (this rank's markers). Collective.
  /// Errors: DivergedError if a marker has left the box.
  void locate(const Points<Dim>& positions);

  /// force += S F with nodal forces F [N; per unit depth in the plane]; a face vector [N/m3]. Collective.
  void spread(const Points<Dim>& forces, Vec force) const;
  /// Spreads as above and returns the reaction of the box's sides [N], summed over all ranks.
  Point<Dim> spread_with_reaction(const Points<Dim>& forces, Vec force) const;

  /// density += S m with nodal masses m [kg], for each component's faces; mass beyond sides of the box is folded back.
  /// Collective.
  void spread_mass(const std::vector<double>& masses, Vec density) const;
  /// Spreads amounts as masses are spread, with a separate amount for each component.
  void spread_amounts(const Points<Dim>& amounts, Vec density) const;

  /// Velocity at an offset of at most `sample_reach` cells from where each marker was located, linearly between faces
  /// and not with the delta; places beyond the box are moved to its surface. Collective.
  Points<Dim> sample(Vec local_velocity, const Points<Dim>& offsets) const;
  static constexpr double sample_reach = 1.5;  ///< largest offset of a sample for which the ghosts suffice [cells]

  /// U = J u for a local velocity whose ghosts are filled. Collective.
  Points<Dim> interpolate(Vec local_velocity) const;
  /// U = J u for a velocity that is zero except in and beyond the sides of the box, or one side if it is named:
  /// interpolates only to markers near them.
  Points<Dim> interpolate_from_sides(Vec local_velocity, const std::optional<SideName>& side = {}) const;
  /// The sides that markers in this rank's cells reach.
  const typename Boundary<Dim>::SideSet& reached_sides() const { return reached_sides_; }

 private:
  void find_stencils(const Points<Dim>& before);
  const FaceStencils<Dim>& interpolate_stencils() const {
    return interpolate_stencils_ ? *interpolate_stencils_ : spread_stencils_;
  }
  void find_beside_sides();
  void add_to_local(const Points<Dim>& values, Vec local) const;
  Point<Dim> spread_of_rank(const Points<Dim>& forces, Vec force) const;

  const Grid<Dim>& grid_;
  const Boundary<Dim>& boundary_;
  DeltaOptions delta_;
  MarkerExchange<Dim> exchange_;
  Points<Dim> here_;                   ///< positions of the markers in this rank's cells, folded into the box
  FaceStencils<Dim> spread_stencils_;  ///< stencils of the markers in this rank's cells
  std::optional<FaceStencils<Dim>> interpolate_stencils_;  ///< only if interpolation has another delta
  /// A marker whose stencil reaches sides.
  struct BesideSides {
    std::size_t number;
    typename Boundary<Dim>::SideSet reached;
  };
  std::vector<BesideSides> beside_sides_;
  typename Boundary<Dim>::SideSet reached_sides_{};
};

/// Velocity of each marker per unit time if every marker k bears the nodal force weights[k]: row sums of J H S / rho,
/// which bound the mobility of the markers before projection. With the markers' lengths as weights it is the mobility
/// per area m_k [m2/kg] that bounds the explicit step; with ones that of nodal forces [1/kg; m/kg in the plane]. The
/// fluid's share H of the faces may be null: no solids. Collective.
template <int Dim>
std::vector<double> row_sum_mobility(const Transfer<Dim>& transfer, const Grid<Dim>& grid,
                                     const Boundary<Dim>& boundary, Vec density, Vec fluid_fraction,
                                     const std::vector<double>& weights);

extern template class Transfer<2>;
extern template class Transfer<3>;

}  // namespace washfsi
