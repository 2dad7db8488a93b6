// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/linear_fabric.hpp"

#include <cmath>

#include "washfsi/cloth/warp_weft.hpp"

namespace washfsi {

LinearFabric::LinearFabric(const LinearModuli& moduli)
    : moduli_(moduli),
      coupling_(moduli.poisson * std::sqrt(moduli.ke_s * moduli.ke_r)),
      bending_{.s = moduli.kb_s,
               .r = moduli.kb_r,
               .cross = moduli.poisson * std::sqrt(moduli.kb_s * moduli.kb_r),
               .twist = moduli.kt,
               .alone = 1 - moduli.poisson * moduli.poisson} {}

namespace {

// nu_P from nu_sr and, if given, nu_rs: nu_sr K_e,r = nu_rs K_e,s (3.3.5), or the strain energy would not exist.
double symmetric_poisson(const OptionBlock& block, const std::vector<double>& given, double ratio) {
  const double along = given[0], wanted = along * ratio;
  if (given.size() > 1 && std::abs(given[1] - wanted) > 1e-6 * std::max(std::abs(wanted), std::abs(given[1])))
    block.refuse("poisson", to_text(along) + "," + to_text(given[1]),
                 "symmetric, nu_sr Ke_r = nu_rs Ke_s: the second must be " + to_text(wanted));
  const double mean = along * std::sqrt(ratio);
  if (!(std::abs(mean) < 1)) block.refuse("poisson", to_text(along), "so small that sqrt(nu_sr nu_rs) is below 1");
  return mean;
}

}  // namespace

LinearFabric LinearFabric::from_options(OptionBlock& block, std::size_t directions) {
  WarpWeft ke{8e3, 8e3}, kb{1e-5, 1e-5};
  read_warp_weft(block, "ke", ke, directions, "N/m", positive, "extensional stiffness");
  read_warp_weft(block, "kb", kb, directions, "N m", non_negative, "bending stiffness (0: none)");
  if (directions == 1) return LinearFabric({.ke_s = ke[0], .kb_s = kb[0]});
  LinearModuli moduli{.ke_s = ke[0], .ke_r = ke[1], .kb_s = kb[0], .kb_r = kb[1]};
  std::vector<double> poisson{0};
  block.reals("poisson", poisson, 1, 2, "-", "Poisson's ratio nu_sr, and nu_rs = nu_sr Ke_r/Ke_s if given");
  moduli.poisson = symmetric_poisson(block, poisson, ke[1] / ke[0]);
  moduli.ks = 0.5 * (1 - moduli.poisson) * std::sqrt(ke[0] * ke[1]);
  moduli.kt = (1 - moduli.poisson) * std::sqrt(kb[0] * kb[1]);
  block.real("ks", moduli.ks, "N/m", non_negative, "shear stiffness; 0: none; default: that of an isotropic sheet");
  block.real("kt", moduli.kt, "N m", non_negative, "twisting stiffness; 0: none; default: that of an isotropic sheet");
  return LinearFabric(moduli);
}

LargestModuli LinearFabric::largest_moduli() const {
  return {.s = moduli_.ke_s, .r = moduli_.ke_r, .shear = moduli_.ks, .poisson = std::abs(moduli_.poisson)};
}

}  // namespace washfsi
