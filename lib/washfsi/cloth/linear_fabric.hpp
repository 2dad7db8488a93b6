// SPDX-License-Identifier: BSD-3-Clause
//
// Orthotropic linear elasticity, thesis 3.3.5: membrane forces and moments are linear in strains and curvatures,
//   N11 = K_e,s E11 + nu_P sqrt(K_e,s K_e,r) E22,  N22 likewise,  N12 = 2 K_s E12
//   M_b,11 = K_b,s n.X_ss + nu_P sqrt(K_b,s K_b,r) n.X_rr,  M_b,22 likewise,  M_b,12 = K_t n.X_sr
// On the lattice the means <E11> and <E22> of a quad are coupled. A bare edge is free to contract across: its modulus
// is (1 - nu_P^2) K_e.
#pragma once

#include "washfsi/cloth/fabric_law.hpp"

namespace washfsi {

/// Moduli of an orthotropic sheet; in 2D there is nothing along weft.
struct LinearModuli {
  double ke_s = 0, ke_r = 0;  ///< moduli of extension K_e [N/m]
  double ks = 0;              ///< modulus of shear K_s, N12 = 2 K_s E12 [N/m]
  double kb_s = 0, kb_r = 0;  ///< moduli of bending K_b [N m]
  double kt = 0;              ///< modulus of twist K_t, M_b,12 = K_t n.X_sr [N m]
  double poisson = 0;         ///< nu_P, the geometric mean of nu_sr and nu_rs
};

/// A quad whose mean strains are coupled, with its energy per area coupling <E11> <E22> + 1/2 shear (2 E12)^2.
class MeanQuad {
 public:
  MeanQuad(const MeanTangent& tangent, const QuadVector& strains) : tangent_(tangent), e_(strains) {}

  double energy() const {
    return 0.25 * tangent_.coupling * (e_[0] + e_[1]) * (e_[2] + e_[3]) + 0.5 * tangent_.shear * e_[4] * e_[4];
  }
  QuadVector resultants() const { return tangent_ * e_; }
  const MeanTangent& tangent() const { return tangent_; }

 private:
  MeanTangent tangent_;
  QuadVector e_;
};

/// The law of orthotropic linear elasticity.
class LinearFabric {
 public:
  static constexpr const char* name = "linear";

  LinearFabric() = default;
  explicit LinearFabric(const LinearModuli& moduli);
  static LinearFabric from_options(OptionBlock& block, std::size_t directions);

  const LinearModuli& moduli() const { return moduli_; }
  bool is_isotropic() const { return moduli_.ke_s == moduli_.ke_r && moduli_.kb_s == moduli_.kb_r; }

  EdgeResponse warp(double strain, double bare) const { return edge(moduli_.ke_s, strain, bare); }
  EdgeResponse weft(double strain, double bare) const { return edge(moduli_.ke_r, strain, bare); }
  MeanQuad quad(const QuadVector& strains) const { return {{coupling_, moduli_.ks}, strains}; }
  double warp_modulus(double) const { return moduli_.ke_s; }
  double weft_modulus(double) const { return moduli_.ke_r; }
  const BendingModuli& bending() const { return bending_; }
  LargestModuli largest_moduli() const;

 private:
  EdgeResponse edge(double ke, double strain, double bare) const {
    const double tangent = (1 - moduli_.poisson * moduli_.poisson * bare) * ke;
    return {0.5 * tangent * strain * strain, tangent * strain, tangent};
  }

  LinearModuli moduli_;
  double coupling_ = 0;  ///< dN11/dE22 [N/m]
  BendingModuli bending_;
};

}  // namespace washfsi
