// SPDX-License-Identifier: BSD-3-Clause
//
// Laws whose energy is a function of the strains at a point, on quads and on a whole sheet.
#include "support/pointwise_quad.hpp"

#include "support/elasticity.hpp"
#include "washfsi/cloth/sheet_stiffness.hpp"

namespace washfsi::test {
namespace {

/// An incompressible neo-Hookean membrane: mu/2 (C11 + C22 + 1/det C - 3), C = 1 + 2E; mu = G times the thickness.
struct NeoHookean {
  double mu = 40;

  static double determinant(const PointStrain& e) { return (1 + 2 * e[0]) * (1 + 2 * e[1]) - e[2] * e[2]; }
  /// Derivatives of the determinant.
  static PointStrain slope(const PointStrain& e) { return {2 * (1 + 2 * e[1]), 2 * (1 + 2 * e[0]), -2 * e[2]}; }

  double energy(const PointStrain& e) const { return 0.5 * mu * (2 * e[0] + 2 * e[1] - 1 + 1 / determinant(e)); }
  PointStrain resultants(const PointStrain& e) const {
    return 0.5 * mu * (PointStrain(2, 2, 0) - slope(e) / std::pow(determinant(e), 2));
  }
  Eigen::Matrix3d tangent(const PointStrain& e) const {
    const double d = determinant(e);
    Eigen::Matrix3d curvature;
    curvature << 0, 4, 0, 4, 0, 0, 0, 0, -2;
    return 0.5 * mu * (2 / (d * d * d) * slope(e) * slope(e).transpose() - curvature / (d * d));
  }
  /// With no stress across: C22 = C11^(-1/2).
  EdgeResponse alone(double strain) const {
    const double c = 1 + 2 * strain, root = std::sqrt(c);
    return {0.5 * mu * (c + 2 / root - 3), mu * (1 - 1 / (c * root)), 3 * mu / (c * c * root)};
  }
  EdgeResponse alone_s(double strain) const { return alone(strain); }
  EdgeResponse alone_r(double strain) const { return alone(strain); }
};

/// The energy of the linear law.
struct Quadratic {
  LinearModuli moduli{.ke_s = 50, .ke_r = 30, .ks = 8, .poisson = 0.3};

  Eigen::Matrix3d tangent(const PointStrain&) const {
    const double cross = moduli.poisson * std::sqrt(moduli.ke_s * moduli.ke_r);
    Eigen::Matrix3d matrix;
    matrix << moduli.ke_s, cross, 0, cross, moduli.ke_r, 0, 0, 0, moduli.ks;
    return matrix;
  }
  PointStrain resultants(const PointStrain& e) const { return tangent(e) * e; }
  double energy(const PointStrain& e) const { return 0.5 * e.dot(resultants(e)); }
  EdgeResponse alone_s(double strain) const { return LinearFabric(moduli).warp(strain, 1); }
  EdgeResponse alone_r(double strain) const { return LinearFabric(moduli).weft(strain, 1); }
};

/// A law with such an energy: all of it on the quads, on the edges that of their bare share.
template <class Energy>
class PointwiseFabric {
 public:
  static constexpr const char* name = "pointwise";
  static PointwiseFabric from_options(OptionBlock&, std::size_t) { return {}; }

  EdgeResponse warp(double strain, double bare) const { return share(bare, energy_.alone_s(strain)); }
  EdgeResponse weft(double strain, double bare) const { return share(bare, energy_.alone_r(strain)); }
  PointwiseQuad<Energy> quad(const QuadVector& strains) const { return {energy_, strains}; }
  double warp_modulus(double strain) const { return energy_.tangent({strain, 0, 0})(0, 0); }
  double weft_modulus(double strain) const { return energy_.tangent({0, strain, 0})(1, 1); }
  BendingModuli bending() const { return {}; }
  LargestModuli largest_moduli() const { return {}; }

 private:
  static EdgeResponse share(double bare, const EdgeResponse& of) {
    return {bare * of.energy, bare * of.resultant, bare * of.tangent};
  }

  Energy energy_;
};

static_assert(FabricLaw<PointwiseFabric<NeoHookean>> && FabricLaw<PointwiseFabric<Quadratic>>);

/// A sheet of a law that is not in the list of fabrics.
template <FabricLaw Law>
struct LawModel {
  Sheet sheet;
  Law law;

  explicit LawModel(std::size_t width) : sheet{.width = width, .ds = woven_ds, .dr = woven_dr} {}

  double energy(const Points<3>& x) const { return elastic_energy_of(law, SheetLattice<3>(sheet, x), 0, x.size()); }
  Points<3> forces(const Points<3>& x) const {
    const SheetLattice<3> lattice(sheet, x);
    Points<3> forces(x.size(), Point<3>::Zero());
    add_membrane_forces<3>(lattice, resultants_of(law, lattice, strains_of(lattice)), forces);
    return forces;
  }
  Eigen::MatrixXd stiffness(const Points<3>& x) const {
    const SheetLattice<3> lattice(sheet, x);
    return sum_of_blocks<3>(x.size(), [&](const AddBlock<3>& add) {
      add_membrane_stiffness<3>(law, lattice, GeometricStiffness::all, add);
    });
  }
  Points<3> force_rates(const Points<3>& x, const Points<3>& direction) const {
    Points<3> rates(x.size(), Point<3>::Zero());
    add_membrane_force_rates<3>(law, SheetLattice<3>(sheet, x), SheetLattice<3>(sheet, direction), rates);
    return rates;
  }
};

// Little crumpled: at the corners of uneven quads det C may vanish.
Points<3> uneven_sheet(const Shape& shape) {
  Points<3> x = flat_sheet(shape.rows, shape.width, 1.1 * woven_ds, 1.2 * woven_dr);
  const Points<3> moves = random_points<3>(x.size(), 3, 0.15 * woven_dr);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += moves[k];
  return x;
}

TEST(PointwiseQuad, ResultantsAndTangentAreDerivativesOfItsEnergy) {
  const QuadVector strains(0.1, -0.05, 0.2, 0.3, 0.15);
  const auto quad = [](const QuadVector& e) { return PointwiseQuad<NeoHookean>({}, e); };
  constexpr double step = 1e-6;
  for (int i = 0; i < 5; ++i) {
    const auto above = quad(strains + step * QuadVector::Unit(i)), below = quad(strains - step * QuadVector::Unit(i));
    EXPECT_NEAR(quad(strains).resultants()[i], (above.energy() - below.energy()) / (2 * step), 1e-7);
    const QuadVector column = (above.resultants() - below.resultants()) / (2 * step);
    EXPECT_LE((quad(strains).tangent().col(i) - column).norm(), 1e-6);
  }
}

TEST(PointwiseQuad, BearsTheEnergyOfAUniformStrain) {
  const PointStrain strain(0.1, 0.2, 0.15);
  const QuadVector strains(strain[0], strain[0], strain[1], strain[1], strain[2]);
  EXPECT_NEAR(PointwiseQuad<NeoHookean>({}, strains).energy(), NeoHookean().energy(strain), 1e-13);
}

TEST(PointwiseQuad, GivesASheetConsistentForcesAndStiffness) {
  for (const Shape& shape : shapes)
    expect_consistent<3>(LawModel<PointwiseFabric<NeoHookean>>(shape.width), uneven_sheet(shape), 1e-8, 1e-5);
}

TEST(PointwiseQuad, WithTheLinearLawsEnergyIsTheLinearLaw) {
  const Quadratic quadratic;
  for (const Shape& shape : shapes) {
    const LawModel<PointwiseFabric<Quadratic>> pointwise(shape.width);
    SheetModel<3> by_moduli{pointwise.sheet};
    by_moduli.sheet.fabric = LinearFabric(quadratic.moduli);
    const Points<3> x = crumpled_sheet(shape.rows, shape.width, woven_ds, woven_dr, 5);
    const Eigen::MatrixXd stiffness = by_moduli.stiffness(x);
    EXPECT_NEAR(pointwise.energy(x), by_moduli.energy(x), 1e-13 * by_moduli.energy(x));
    EXPECT_LE((as_vector<3>(pointwise.forces(x)) - as_vector<3>(by_moduli.forces(x))).norm(),
              1e-13 * as_vector<3>(by_moduli.forces(x)).norm());
    EXPECT_LE((pointwise.stiffness(x) - stiffness).norm(), 1e-13 * stiffness.norm());
  }
}

// Pulled along s with free edges it contracts as an incompressible membrane does: no marker but at the ends is pulled.
TEST(PointwiseQuad, LetsAFreeSheetContract) {
  constexpr double c = 1.5;
  const LawModel<PointwiseFabric<NeoHookean>> model(6);
  const Points<3> x = flat_sheet(7, 6, woven_ds * std::sqrt(c), woven_dr * std::pow(c, -0.25)),
                  forces = model.forces(x);
  const double pull = model.sheet.dr * model.law.warp(0.5 * (c - 1), 1).resultant * std::sqrt(c);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k / 6;
    EXPECT_NEAR(forces[k][0], i == 0 ? pull : i == 6 ? -pull : 0, 1e-13) << k;
    EXPECT_NEAR(i == 0 || i == 6 ? 0 : forces[k].norm(), 0, 1e-13) << k;
  }
}

}  // namespace
}  // namespace washfsi::test
