// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/cloth/fabric_law.hpp"

namespace washfsi::test {

/// E11, E22 and 2 E12 at a point, or N11, N22 and N12.
using PointStrain = Eigen::Vector3d;

/// An energy per area that is a function of the strains at a point, with its first and second derivatives.
template <class Energy>
concept PointwiseEnergy = requires(const Energy& energy, const PointStrain& strain) {
  { energy.energy(strain) } -> std::convertible_to<double>;
  { energy.resultants(strain) } -> std::convertible_to<PointStrain>;
  { energy.tangent(strain) } -> std::convertible_to<Eigen::Matrix3d>;
};

/// A quad that bears such an energy (a QuadResponse): the mean over its corners, at each the strains of the two edges
/// that meet there and the shear of the middle. Where a quad is so uneven that its edges at a corner are much shorter
/// than the mean ones, no deformation may have these strains: 1 + 2E need not be positive definite.
template <PointwiseEnergy Energy>
class PointwiseQuad {
 public:
  PointwiseQuad(const Energy& energy, const QuadVector& strains) : energy_(energy), strains_(strains) {}

  double energy() const {
    double sum = 0;
    for (int p = 0; p < 4; ++p) sum += 0.25 * energy_.energy(strains_(strains_at_corner(p)));
    return sum;
  }
  QuadVector resultants() const {
    QuadVector sum = QuadVector::Zero();
    for (int p = 0; p < 4; ++p) {
      const auto at = strains_at_corner(p);
      sum(at) += 0.25 * energy_.resultants(strains_(at));
    }
    return sum;
  }
  QuadMatrix tangent() const {
    QuadMatrix sum = QuadMatrix::Zero();
    for (int p = 0; p < 4; ++p) {
      const auto at = strains_at_corner(p);
      sum(at, at) += 0.25 * energy_.tangent(strains_(at));
    }
    return sum;
  }

 private:
  Energy energy_;
  QuadVector strains_;
};

}  // namespace washfsi::test
