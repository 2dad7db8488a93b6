// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "washfsi/cloth/fibre.hpp"
#include "washfsi/support/options.hpp"

namespace washfsi {

/// A group of equal cloths: how many, how large, of what.
struct ClothGroup {
  std::string name;
  PetscInt count = 1;
  PetscInt markers = 12;         ///< per cloth
  double size = 0.25;            ///< physical length [m] = markers times spacing
  double excess_mass = 0.093;    ///< over the water displaced, rho_s [kg/m2]
  std::string model = "energy";  ///< energy | love
  Fibre fibre;

  static ClothGroup from_options(Options& options, const std::string& name);
};

/// All groups named by -cloths.
std::vector<ClothGroup> cloth_groups_from_options(Options& options);

}  // namespace washfsi
