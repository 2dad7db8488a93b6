// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/crimp_fabric.hpp"

#include <algorithm>

namespace washfsi {

CrimpFabric::CrimpFabric(const LinearFabric& crimped, const Crimp& crimp)
    : crimped_(crimped),
      yarn_modulus_(crimp.yarn_modulus),
      warp_(crimp.yarn_modulus[0] - crimped.moduli().ke_s, crimp.strain[0], crimp.width),
      weft_(crimp.yarn_modulus[1] - crimped.moduli().ke_r, crimp.strain[1], crimp.width) {}

CrimpFabric CrimpFabric::from_options(OptionBlock& block, std::size_t directions) {
  const LinearFabric crimped = LinearFabric::from_options(block, directions);
  const WarpWeft ke{crimped.moduli().ke_s, crimped.moduli().ke_r};
  Crimp crimp{.yarn_modulus = ke, .strain = {0.1, 0.1}};
  block.require("ke_yarn", "extensional stiffness of the straightened yarns");
  read_warp_weft(block, "ke_yarn", crimp.yarn_modulus, directions, "N/m", positive,
                 "extensional stiffness of the straightened yarns");
  for (std::size_t d = 0; d < directions; ++d)
    if (crimp.yarn_modulus[d] < ke[d])
      block.refuse("ke_yarn", to_text(crimp.yarn_modulus[d]), "at least the stiffness with crimp, " + to_text(ke[d]));
  block.require("crimp", "strain at which the yarns are straight");
  read_warp_weft(block, "crimp", crimp.strain, directions, "-", positive, "strain at which the yarns are straight");
  const auto used = crimp.strain.begin() + static_cast<long>(directions);
  for (auto strain = crimp.strain.begin(); strain != used; ++strain)
    if (*strain > 1) block.refuse("crimp", to_text(*strain), "a strain, at most 1 (5 % are 0.05)");
  const double least = *std::min_element(crimp.strain.begin(), used);
  crimp.width = least / 10;
  block.real("crimp_width", crimp.width, "-", positive,
             "half width of the knee of the curve; default: a tenth of the smaller strain there");
  if (crimp.width > least)
    block.refuse("crimp_width", to_text(crimp.width), "at most the smaller strain at the knee, " + to_text(least));
  return {crimped, crimp};
}

LargestModuli CrimpFabric::largest_moduli() const {
  LargestModuli largest = crimped_.largest_moduli();
  largest.s = yarn_modulus_[0];
  largest.r = yarn_modulus_[1];
  return largest;
}

}  // namespace washfsi
