// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "washfsi/cloth/sheet.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// A group of equal cloths: how many, how large, of what, held where, loaded by what.
template <int Dim>
struct ClothGroup {
  std::string name;
  PetscInt count = 1;
  /// Markers of each cloth along s and r; a fibre, as cloth is in the plane, has one along r.
  std::array<PetscInt, 2> markers{12, 1};
  /// Physical length along s and r [m] = markers times spacing; in the plane the unit depth along r.
  std::array<double, 2> size{0.25, 1};
  double excess_mass = 0.093;    ///< over the water displaced, rho_s [kg/m2]
  std::string model = "energy";  ///< energy | love
  std::string shape = "flat";    ///< at the start: flat | ellipse (a ring) | mode | bar_mode | crumpled
  Sheet sheet;

  std::string hold = "none";  ///< where springs hold it: none | middle | first | corners | edge
  double hold_stiffness = 0;  ///< of the spring at each held marker [N/m; per unit depth in the plane]; 0: Ke/ds
  Point<Dim> load = Point<Dim>::Zero();             ///< constant force per undeformed area [N/m2]
  Point<Dim> end_force_first = Point<Dim>::Zero();  ///< at the edge before the first row [N; N/m in the plane]
  Point<Dim> end_force_last = Point<Dim>::Zero();   ///< after the last

  static ClothGroup from_options(Options& options, const std::string& name);

  PetscInt marker_count() const { return markers[0] * markers[1]; }  ///< of one cloth
  /// Which markers of a cloth the springs hold, in ascending order.
  std::vector<PetscInt> held_markers() const;
};

/// All groups named by -cloths.
template <int Dim>
std::vector<ClothGroup<Dim>> cloth_groups_from_options(Options& options);

extern template struct ClothGroup<2>;
extern template struct ClothGroup<3>;

}  // namespace washfsi
