// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/refinement.hpp"

namespace washfsi {

/// How elasticity acts on the markers: as minus the gradient of a discrete energy, or by the thesis's strong form.
enum class ElasticModel { energy, love };
const ChoiceNames<ElasticModel>& names_of(ElasticModel);

/// Where springs hold a cloth: nowhere; at the one or two markers in the middle; along the first row, a hinge; at its
/// corners; along the first two rows, a clamp.
enum class Hold { none, middle, first, corners, edge };
const ChoiceNames<Hold>& names_of(Hold);

/// Shapes at the start, see `shaped_cloth`.
enum class ClothShape { flat, ellipse, mode, bar_mode, crumpled };
const ChoiceNames<ClothShape>& names_of(ClothShape);

/// A group of equal cloths: their number, size, fabric, holding springs and loads.
template <int Dim>
struct ClothGroup {
  std::string name;
  PetscInt count = 1;
  /// Markers of each cloth along s and r; a fibre, as cloth is in the plane, has one along r.
  std::array<PetscInt, 2> markers{12, 1};
  /// Physical length along s and r [m] = parts of the lattice times spacing; in the plane the unit depth along r.
  std::array<double, 2> size{0.25, 1};
  double excess_mass = 0.093;  ///< rho_s, mass in excess of the water displaced [kg/m2]
  double permeance = 0;        ///< speed of water through it over the jump of pressure [m/(s Pa)]; 0: tight
  ElasticModel model = ElasticModel::energy;
  ClothShape shape = ClothShape::flat;  ///< shape at the start; an ellipse is a ring
  Sheet sheet;

  Hold hold = Hold::none;                           ///< where springs hold it
  double hold_stiffness = 0;                        ///< per spring [N/m; per unit depth in 2D]; 0: K_e/ds
  Point<Dim> load = Point<Dim>::Zero();             ///< constant force per undeformed area [N/m2]
  Point<Dim> end_force_first = Point<Dim>::Zero();  ///< force at the edge before the first row [N; N/m in the plane]
  Point<Dim> end_force_last = Point<Dim>::Zero();   ///< force at the edge after the last row [N; N/m in the plane]
  Point<Dim> velocity = Point<Dim>::Zero();         ///< velocity at the start [m/s]

  static ClothGroup from_options(Options& options, const std::string& name, const Refinement& refinement);

  PetscInt marker_count() const { return markers[0] * markers[1]; }  ///< number of markers of one cloth
  /// The markers along s (0) or r (1).
  MarkerRow row(std::size_t axis) const { return {sheet.lattice, static_cast<std::size_t>(markers[axis])}; }
  /// Undeformed area of a marker of a cloth over that of one inside.
  double marker_share(PetscInt marker) const {
    return row(0).share(static_cast<std::size_t>(marker / markers[1])) *
           row(1).share(static_cast<std::size_t>(marker % markers[1]));
  }
  /// An equal share of a cloth's undeformed area for each of its faces, triangles or, in the plane, segments; 0
  /// without.
  double face_area() const;
  /// Which markers of a cloth the springs hold, in ascending order.
  std::vector<PetscInt> held_markers() const;
};

/// Whether any group has this elastic model.
template <int Dim>
bool uses(const std::vector<ClothGroup<Dim>>& groups, ElasticModel model) {
  return std::any_of(groups.begin(), groups.end(), [&](const auto& group) { return group.model == model; });
}

/// All groups named by -cloths.
template <int Dim>
std::vector<ClothGroup<Dim>> cloth_groups_from_options(Options& options, const Refinement& refinement);

extern template struct ClothGroup<2>;
extern template struct ClothGroup<3>;

}  // namespace washfsi
