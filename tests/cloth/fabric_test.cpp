// SPDX-License-Identifier: BSD-3-Clause
//
// Laws of fabric, on their own and on the lattice of a sheet.
#include <Eigen/Cholesky>

#include "support/elasticity.hpp"
#include "washfsi/support/eigensystem.hpp"

namespace washfsi::test {
namespace {

constexpr double beta = 0.2;
const LinearFabric linear(woven_moduli);

// The stretches of a crumpled sheet lie on both sides of the knee.
const Crimp knee{.yarn_modulus = {400, 500}, .strain = {0.05, 0.08}, .width = 0.02};
const CrimpFabric crimped(linear, knee);

Sheet sheet_of(const Fabric& fabric, std::size_t width) {
  return {.width = width, .ds = woven_ds, .dr = woven_dr, .fabric = fabric, .damping = beta};
}

// A flat sheet under the strains E11 and E22.
Points<3> strained(std::size_t rows, std::size_t width, double e11, double e22) {
  return flat_sheet(rows, width, woven_ds * std::sqrt(1 + 2 * e11), woven_dr * std::sqrt(1 + 2 * e22));
}

// The largest eigenvalue of the stiffness per area is at most four times the bound.
double expect_stiffness_below_bound(const Fabric& fabric, std::size_t rows, std::size_t width, double strain) {
  const Sheet sheet = sheet_of(fabric, width);
  const Eigen::MatrixXd matrix =
      stiffness_of<3>(sheet, strained(rows, width, strain, strain), GeometricStiffness::all) / sheet.part_area();
  const double largest = eigensystem<Eigen::Dynamic>(matrix).values.maxCoeff();
  EXPECT_LE(largest, 4 * largest_stiffness(sheet));
  return largest / (4 * largest_stiffness(sheet));
}

TEST(LinearFabric, StiffnessIsBounded) {
  EXPECT_GT(expect_stiffness_below_bound(linear, 9, 8, 0), 0.5);  // and not far below
  EXPECT_GT(expect_stiffness_below_bound(linear, 12, 1, 0), 0.5);
}

// The power of the damping forces against minus beta k (dE/dt)^2 over the areas of all edges.
void expect_dissipation(const Fabric& fabric, std::size_t rows, std::size_t width) {
  const Points<3> x = crumpled_woven(rows, width, 7), u = random_points<3>(x.size(), 8);
  Points<3> forces(x.size(), Point<3>::Zero());
  add_damping_forces<3>(sheet_of(fabric, width), x, u, forces);
  double expected = 0;
  const auto lose = [&](std::size_t a, std::size_t b, double spacing, const auto& modulus) {
    const Point<3> edge = (x[b] - x[a]) / spacing;
    const double strain = 0.5 * (edge.squaredNorm() - 1), rate = edge.dot(u[b] - u[a]) / spacing;
    expected -= woven_ds * woven_dr * beta * modulus(strain) * rate * rate;
  };
  std::visit(
      [&](const auto& law) {
        for (std::size_t k = 0; k < x.size(); ++k) {
          if (k + width < x.size())
            lose(k, k + width, woven_ds, [&](double strain) { return law.warp_modulus(strain); });
          if (k % width + 1 < width) lose(k, k + 1, woven_dr, [&](double strain) { return law.weft_modulus(strain); });
        }
      },
      fabric);
  EXPECT_NEAR(as_vector<3>(forces).dot(as_vector<3>(u)), expected, 1e-12 * std::abs(expected));
}

TEST(LinearFabric, DampingTakesOutItsModulusTimesTheRateOfStrain) {
  expect_dissipation(linear, 5, 6);
  expect_dissipation(linear, 7, 1);
}

TEST(CrimpFabric, ForcesAndStiffnessAreDerivativesOfTheEnergy) {
  for (const auto& [rows, width] : shapes)
    expect_consistent<3>(SheetModel<3>{sheet_of(crimped, width)}, crumpled_woven(rows, width, 3), 1e-6, 1e-4);
  expect_consistent<2>(SheetModel<2>{sheet_of(crimped, 1)}, crumpled_fibre<2>(9, woven_ds, 3), 1e-6, 1e-4);
}

TEST(CrimpFabric, StiffnessWithoutCompressionAndShearIsPositive) {
  const Eigen::MatrixXd matrix =
      stiffness_of<3>(sheet_of(crimped, 6), crumpled_woven(5, 6, 5), GeometricStiffness::of_tension);
  EXPECT_GT(eigensystem<Eigen::Dynamic>(matrix).values[0], -1e-9);
}

TEST(CrimpFabric, DampingTakesOutItsModulusTimesTheRateOfStrain) {
  expect_dissipation(crimped, 5, 6);
  expect_dissipation(crimped, 7, 1);
}

// Yarns that are straight almost from the start: their modulus acts while the strains are still small.
TEST(CrimpFabric, StiffnessIsBounded) {
  const CrimpFabric taut(linear, {.yarn_modulus = {400, 300}, .strain = {1e-4, 1e-4}, .width = 1e-5});
  EXPECT_GT(expect_stiffness_below_bound(taut, 9, 8, 1e-3), 0.5);
  EXPECT_GT(expect_stiffness_below_bound(taut, 12, 1, 1e-3), 0.5);
}

TEST(CrimpFabric, HasTheModulusOfTheCrimpThenThatOfTheYarns) {
  const CrimpFabric sharp(linear, {.yarn_modulus = {400, 500}, .strain = {0.05, 0.08}, .width = 1e-5});
  EXPECT_NEAR(sharp.warp_modulus(0), woven_moduli.ke_s, 1e-4);
  EXPECT_NEAR(sharp.warp_modulus(-0.3), woven_moduli.ke_s, 1e-4);
  EXPECT_NEAR(sharp.warp_modulus(0.05), 0.5 * (woven_moduli.ke_s + 400), 1e-9);
  EXPECT_NEAR(sharp.warp_modulus(0.3), 400, 1e-4);
  EXPECT_NEAR(sharp.weft_modulus(0.3), 500, 1e-4);
  EXPECT_NEAR(sharp.warp(0.05, 0).resultant, 0.05 * woven_moduli.ke_s, 1e-5 * 400);
  EXPECT_NEAR(sharp.warp(0.3, 0).resultant, 0.05 * woven_moduli.ke_s + 0.25 * 400, 1e-5 * 400);
  EXPECT_EQ(crimped.warp(0, 0).resultant, 0);
  EXPECT_EQ(crimped.warp(0, 0).energy, 0);
}

TEST(CrimpFabric, WhoseYarnsAreAsStiffAsTheirCrimpIsLinear) {
  const CrimpFabric even(linear, {.yarn_modulus = {woven_moduli.ke_s, woven_moduli.ke_r}, .strain = {0.1, 0.1}});
  const Points<3> x = crumpled_woven(5, 4, 6);
  const Points<3> forces = energy_forces<3>(sheet_of(even, 4), x),
                  linear_forces = energy_forces<3>(sheet_of(linear, 4), x);
  for (std::size_t m = 0; m < x.size(); ++m) EXPECT_LE((forces[m] - linear_forces[m]).norm(), 1e-12);
}

// The integral of the modulus of the formula from 0, by Simpson's rule.
double tension(double strain) {
  constexpr int intervals = 2000;
  const auto modulus = [](double e) {
    const double x = (e - knee.strain[0]) / knee.width;
    return woven_moduli.ke_s + (knee.yarn_modulus[0] - woven_moduli.ke_s) * 0.5 * (1 + x / std::sqrt(1 + x * x));
  };
  double sum = 0;
  for (int i = 0; i <= intervals; ++i)
    sum += (i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2) * modulus(strain * i / intervals);
  return sum * strain / intervals / 3;
}

// A strip along x, held at its first marker and pulled at its last, at rest: by Newton's method.
Points<2> pulled_strip(const SheetModel<2>& strip, std::size_t markers, double pull) {
  Points<2> x;
  for (std::size_t k = 0; k < markers; ++k) x.emplace_back(woven_ds * static_cast<double>(k), 0);
  const auto along = Eigen::seqN(2, markers - 1, 2);  // x of all markers but the first
  for (int step = 0; step < 50; ++step) {
    Points<2> forces = strip.forces(x);
    forces.back()[0] += pull;
    const Eigen::VectorXd rest = as_vector<2>(forces)(along);
    const Eigen::VectorXd move = strip.stiffness(x)(along, along).ldlt().solve(rest);
    for (std::size_t k = 1; k < markers; ++k) x[k][0] += move[static_cast<Eigen::Index>(k) - 1];
    if (move.norm() < 1e-14) break;
  }
  return x;
}

TEST(CrimpFabric, AStripPulledStretchesAlongItsCurve) {
  constexpr std::size_t markers = 9;
  const LinearFabric strip_of(
      {.ke_s = woven_moduli.ke_s, .kb_s = woven_moduli.kb_s});  // no edge across, which would contract
  const SheetModel<2> strip{
      {.ds = woven_ds, .fabric = CrimpFabric(strip_of, {{knee.yarn_modulus[0], 0}, knee.strain, knee.width})}};
  for (int i = 0; i <= 12; ++i) {
    const double strain = 0.25 * i * knee.strain[0], stretch = std::sqrt(1 + 2 * strain);
    const Points<2> x = pulled_strip(strip, markers, tension(strain) * stretch);
    for (std::size_t k = 0; k + 1 < markers; ++k)
      EXPECT_NEAR((x[k + 1][0] - x[k][0]) / woven_ds, stretch, 1e-10) << strain;
  }
}

}  // namespace
}  // namespace washfsi::test
