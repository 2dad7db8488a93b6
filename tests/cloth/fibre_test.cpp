// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "support/elasticity.hpp"
#include "washfsi/cloth/love.hpp"
#include "washfsi/cloth/sheet_states.hpp"
#include "washfsi/support/eigensystem.hpp"

namespace washfsi::test {
namespace {

constexpr double soft_ke = 50, soft_kb = 0.02;
const Sheet soft{
    .ds = 0.1, .fabric = LinearFabric({.ke_s = soft_ke, .kb_s = soft_kb}), .damping = 0.3, .thickness = 1e-3};

TEST(FibreEnergy, ForcesAndStiffnessAreItsDerivatives) {
  expect_consistent<2>(SheetModel<2>{soft}, crumpled_fibre<2>(7, soft.ds, 3), 1e-6 * soft_ke, 1e-6 * soft_ke / soft.ds);
  expect_consistent<3>(SheetModel<3>{soft}, crumpled_fibre<3>(7, soft.ds, 3), 1e-6 * soft_ke, 1e-6 * soft_ke / soft.ds);
}

template <int Dim>
void expect_positive_without_compression() {
  const Points<Dim> x = crumpled_fibre<Dim>(9, soft.ds, 8);
  const auto least = [](const Eigen::MatrixXd& m) { return eigensystem<Eigen::Dynamic>(m).values[0]; };
  EXPECT_LT(least(stiffness_of<Dim>(soft, x, GeometricStiffness::all)), -1e-3 * soft_ke);
  EXPECT_GT(least(stiffness_of<Dim>(soft, x, GeometricStiffness::of_tension)), -1e-9 * soft_ke / soft.ds);
}

TEST(FibreEnergy, StiffnessWithoutCompressionIsPositive) {
  expect_positive_without_compression<2>();
  expect_positive_without_compression<3>();
}

template <int Dim>
void expect_no_net_force_and_torque() {
  const Points<Dim> x = crumpled_fibre<Dim>(40, soft.ds, 5);
  const Points<Dim> forces = energy_forces<Dim>(soft, x);
  Point<Dim> force = Point<Dim>::Zero();
  Rotation<Dim> torque = Rotation<Dim>::Zero();
  double total_force = 0, total_torque = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    force += forces[k];
    torque += cross<Dim>(x[k], forces[k]);
    total_force += forces[k].norm();
    total_torque += x[k].norm() * forces[k].norm();
  }
  EXPECT_LE(force.norm(), 1e-12 * total_force);
  EXPECT_LE(torque.norm(), 1e-12 * total_torque);
}

TEST(FibreEnergy, ACrumpledFibreHasNoNetForceAndTorque) {
  expect_no_net_force_and_torque<2>();
  expect_no_net_force_and_torque<3>();
}

TEST(FibreEnergy, ARigidMotionCreatesNoForce) {
  Points<2> x;
  for (int k = 0; k < 9; ++k) x.emplace_back(3 + 0.1 * k * std::cos(1.0), -1 + 0.1 * k * std::sin(1.0));
  for (const auto& force : energy_forces<2>(soft, x)) EXPECT_LE(force.norm(), 1e-12 * soft_ke);
}

TEST(FibreDamping, TakesEnergyOutAndSparesRigidMotion) {
  const Points<2> x = crumpled_fibre<2>(20, soft.ds, 7), u = random_points<2>(20, 8);
  Points<2> forces(20, Point<2>::Zero()), rigid(20, Point<2>::Zero()), turning;
  add_damping_forces<2>(soft, x, u, forces);
  double power = 0;
  for (std::size_t k = 0; k < 20; ++k) power += forces[k].dot(u[k]);
  EXPECT_LT(power, 0);
  for (const auto& place : x) turning.emplace_back(1 - 2 * place[1], 3 + 2 * place[0]);
  add_damping_forces<2>(soft, x, turning, rigid);
  for (const auto& force : rigid) EXPECT_LE(force.norm(), 1e-11 * soft_ke);
}

// Frequency of the first bending mode of a free beam of n markers, mass 1 per length, Kb = 1, length 1, from the
// eigenvalues of the forces for small transverse deflections.
template <class AddForces>
double first_bending_frequency(std::size_t n, const AddForces& add_forces,
                               MarkerLattice lattice = MarkerLattice::centred) {
  const MarkerRow row(lattice, n);
  const Sheet fibre{.ds = 1 / row.parts(), .fabric = LinearFabric({.ke_s = 1, .kb_s = 1}), .lattice = lattice};
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::MatrixXd stiffness(size, size);
  for (std::size_t j = 0; j < n; ++j) {
    Points<2> x, forces(n, Point<2>::Zero());
    for (std::size_t k = 0; k < n; ++k) x.emplace_back(fibre.ds * static_cast<double>(k), k == j ? 1e-7 : 0.0);
    add_forces(fibre, x, forces);
    for (std::size_t k = 0; k < n; ++k)
      stiffness(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) =
          -forces[k][1] / 1e-7 / (row.share(k) * fibre.ds);
  }
  const Eigen::VectorXcd eigenvalues = Eigen::EigenSolver<Eigen::MatrixXd>(stiffness, false).eigenvalues();
  double lowest = 1e30;
  for (const auto& value : eigenvalues)
    if (value.real() > 100) lowest = std::min(lowest, value.real());  // the two rigid modes are near 0
  return std::sqrt(lowest);
}

constexpr double exact_bending_frequency = 22.373285448061;  // (4.730040744862704)^2

TEST(FibreEnergy, BendingFrequencyConvergesAtSecondOrder) {
  const auto add = [](const Sheet& fibre, const Points<2>& x, Points<2>& f) { add_energy_forces<2>(fibre, x, f); };
  for (const MarkerLattice lattice : {MarkerLattice::centred, MarkerLattice::nodal}) {
    const double coarse = first_bending_frequency(17, add, lattice) / exact_bending_frequency - 1;
    const double fine = first_bending_frequency(33, add, lattice) / exact_bending_frequency - 1;
    std::printf("%s: %.3f %% of 17, %.3f %% of 33 markers\n", name_of(lattice).c_str(), 100 * coarse, 100 * fine);
    EXPECT_LT(std::abs(coarse), lattice == MarkerLattice::nodal ? 0.02 : 0.003);
    EXPECT_GT(std::log2(coarse / fine), 1.7);
  }
}

TEST(LoveFibre, BendingFrequencyConvergesAtSecondOrder) {
  const auto add = [](const Sheet& fibre, const Points<2>& x, Points<2>& f) { add_love_forces(fibre, x, f); };
  const double coarse = first_bending_frequency(17, add) / exact_bending_frequency - 1;
  const double fine = first_bending_frequency(33, add) / exact_bending_frequency - 1;
  EXPECT_LT(std::abs(coarse), 0.03);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

// Both must approach F = -Kb w_ssss for a small smooth deflection w (formulation 3.1).
TEST(LoveFibre, AgreesWithTheEnergyFormForSmallDeflections) {
  std::array<double, 2> difference{}, largest{};
  for (std::size_t level = 0; level < 2; ++level) {
    const std::size_t n = 40U << level;
    const Sheet fibre{.ds = 1.0 / static_cast<double>(n), .fabric = LinearFabric({.ke_s = 10, .kb_s = 0.1})};
    Points<2> x, energy(n, Point<2>::Zero()), love(n, Point<2>::Zero());
    for (std::size_t k = 0; k < n; ++k) {
      const double s = fibre.ds * (static_cast<double>(k) + 0.5);
      x.emplace_back(s, 1e-6 * std::exp(-40 * (s - 0.5) * (s - 0.5)));
    }
    add_energy_forces<2>(fibre, x, energy);
    add_love_forces(fibre, x, love);
    for (std::size_t k = n / 4; k < 3 * n / 4; ++k) {
      difference[level] = std::max(difference[level], std::abs(energy[k][1] - love[k][1]));
      largest[level] = std::max(largest[level], std::abs(energy[k][1]));
    }
  }
  EXPECT_LT(difference[1] / largest[1], 0.06);
  EXPECT_GT(std::log2(difference[0] / largest[0] / (difference[1] / largest[1])), 1.8);
}

TEST(FibreStress, OfAUniformlyStretchedFibreIsItsTensionOverThickness) {
  Points<2> x;
  for (int k = 0; k < 8; ++k) x.emplace_back(0.1 * 1.02 * k, 0);
  const std::vector<MarkerState> states = marker_states<2>(soft, x);
  const double tension = soft_ke * 0.5 * (1.02 * 1.02 - 1);
  for (std::size_t k = 1; k < 7; ++k) {
    EXPECT_NEAR(states[k].membrane_stress[ss], tension / soft.thickness, 1e-9 * tension / soft.thickness);
    EXPECT_NEAR(states[k].stretch, 0.02, 1e-12);
    EXPECT_NEAR(states[k].bending_stress[ss], 0, 1e-9 * tension / soft.thickness);
  }
}

TEST(FibreStress, OfACircleIsItsMomentAtTheSurface) {
  constexpr double radius = 2;
  Points<2> x;
  const double angle = 2 * std::asin(0.5 * soft.ds / radius);  // chords of one spacing
  for (int k = 0; k < 8; ++k) x.emplace_back(radius * std::cos(angle * k), radius * std::sin(angle * k));
  const std::vector<MarkerState> states = marker_states<2>(soft, x);
  for (std::size_t k = 1; k < 7; ++k) {
    EXPECT_NEAR(states[k].curvature, 1 / radius, 1e-9);
    EXPECT_NEAR(states[k].bending_stress[ss], 6 * soft_kb / radius / (soft.thickness * soft.thickness), 1e-3);
    EXPECT_NEAR(states[k].membrane_stress[ss], 0, 1e-6);
  }
}

}  // namespace
}  // namespace washfsi::test
