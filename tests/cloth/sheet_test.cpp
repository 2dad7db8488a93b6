// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/elasticity.hpp"
#include "washfsi/cloth/love.hpp"
#include "washfsi/support/eigensystem.hpp"

namespace washfsi::test {
namespace {

Sheet woven(std::size_t width) {
  return {.width = width,
          .ds = woven_ds,
          .dr = woven_dr,
          .fabric = LinearFabric(woven_moduli),
          .damping = 0.2,
          .thickness = 1e-3};
}

Points<3> love_forces(const Sheet& sheet, const Points<3>& x) {
  Points<3> forces(x.size(), Point<3>::Zero());
  add_love_forces(sheet, x, forces);
  return forces;
}

TEST(SheetEnergy, ForcesAndStiffnessAreItsDerivatives) {
  for (const auto& [rows, width] : shapes)
    expect_consistent<3>(SheetModel<3>{woven(width)}, crumpled_woven(rows, width, 3), 1e-8, 1e-6);
}

TEST(SheetEnergy, StiffnessWithoutCompressionAndShearIsPositive) {
  const Points<3> x = crumpled_woven(5, 6, 5);
  const auto least = [&](GeometricStiffness geometric) {
    const Eigen::MatrixXd matrix = stiffness_of<3>(woven(6), x, geometric);
    return eigensystem<Eigen::Dynamic>(matrix).values[0];
  };
  EXPECT_LT(least(GeometricStiffness::all), -1e-2);
  EXPECT_GT(least(GeometricStiffness::of_tension), -1e-10);
}

TEST(SheetEnergy, ACrumpledSheetHasNoNetForceAndTorque) {
  const Points<3> x = crumpled_woven(12, 9, 5), forces = energy_forces<3>(woven(9), x);
  Point<3> force = Point<3>::Zero(), torque = Point<3>::Zero();
  double total_force = 0, total_torque = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    force += forces[k];
    torque += x[k].cross(forces[k]);
    total_force += forces[k].norm();
    total_torque += x[k].norm() * forces[k].norm();
  }
  EXPECT_LE(force.norm(), 1e-12 * total_force);
  EXPECT_LE(torque.norm(), 1e-12 * total_torque);
}

TEST(SheetEnergy, ARigidMotionCreatesNoForce) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5 * M_PI, Point<3>(1, 2, -1).normalized()).toRotationMatrix();
  Points<3> x = flat_sheet(6, 5, woven_ds, woven_dr);
  for (auto& place : x) place = turn * place + Point<3>(3, -1, 2);
  for (const auto& force : energy_forces<3>(woven(5), x)) EXPECT_LE(force.norm(), 1e-12 * woven_moduli.ke_s);
}

// Work of the damping on random velocities, and none on a turning sheet.
TEST(SheetDamping, TakesEnergyOutAndSparesRigidMotion) {
  const Points<3> x = crumpled_woven(5, 6, 7), u = random_points<3>(30, 8);
  Points<3> forces(30, Point<3>::Zero()), rigid(30, Point<3>::Zero()), turning;
  add_damping_forces<3>(woven(6), x, u, forces);
  double power = 0;
  for (std::size_t k = 0; k < 30; ++k) power += forces[k].dot(u[k]);
  EXPECT_LT(power, 0);
  for (const auto& place : x) turning.push_back(Point<3>(1, 2, 3) + Point<3>(-1, 3, 2).cross(place));
  add_damping_forces<3>(woven(6), x, turning, rigid);
  for (const auto& force : rigid) EXPECT_LE(force.norm(), 1e-11 * woven_moduli.ke_s);
}

// Uniform extension along s with free edges along r: N22 = 0 needs E22 = -nu_sr E11, and then no marker inside is
// pulled.
TEST(SheetEnergy, ContractsByPoissonsRatioWhereItsEdgesAreFree) {
  Sheet sheet = woven(6);
  const double nu = woven_moduli.poisson, nu_sr = nu * std::sqrt(woven_moduli.ke_s / woven_moduli.ke_r);
  sheet.fabric =
      LinearFabric({.ke_s = woven_moduli.ke_s, .ke_r = woven_moduli.ke_r, .ks = woven_moduli.ks, .poisson = nu});
  const double e11 = 0.01, e22 = -nu_sr * e11;
  const Points<3> x = flat_sheet(7, 6, woven_ds * std::sqrt(1 + 2 * e11), woven_dr * std::sqrt(1 + 2 * e22));
  const Points<3> forces = energy_forces<3>(sheet, x);
  const double pull = woven_moduli.ke_s * (1 - nu * nu) * e11 * std::sqrt(1 + 2 * e11) * woven_dr;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k / 6;
    const Point<3> expected = i == 0 ? Point<3>(pull, 0, 0) : i == 6 ? Point<3>(-pull, 0, 0) : Point<3>::Zero();
    // half of the quads' share is missing in the outermost rows of edges along r
    if (i > 0 && i < 6) {
      EXPECT_LE((forces[k] - expected).norm(), 1e-12 * woven_moduli.ke_s) << k;
    } else {
      EXPECT_NEAR(forces[k][0], expected[0], 1e-12 * woven_moduli.ke_s) << k;
    }
  }
}

enum class Motion { bending, in_plane };

// A free square plate: side 1, mass 1 per area, Ke = 1, Kb = 1, Kt = 1 - nu; for motions in its plane of no thickness.
Sheet square(std::size_t n, double nu, Motion motion = Motion::bending,
             MarkerLattice lattice = MarkerLattice::centred) {
  const double spacing = 1 / MarkerRow(lattice, n).parts(), kb = motion == Motion::bending ? 1 : 0;
  const LinearModuli plate{
      .ke_s = 1, .ke_r = 1, .ks = 0.5 * (1 - nu), .kb_s = kb, .kb_r = kb, .kt = (1 - nu) * kb, .poisson = nu};
  return {.width = n, .ds = spacing, .dr = spacing, .fabric = LinearFabric(plate), .lattice = lattice};
}

// Frequencies of small motions about the flat state from the eigenvalues of the forces, without the rigid motions.
template <class Forces>
std::vector<double> frequencies(const Sheet& sheet, Motion motion, const Forces& forces_of) {
  const std::size_t n = sheet.width;
  const MarkerRow side(sheet.lattice, n);
  const std::vector<int> axes = motion == Motion::bending ? std::vector<int>{2} : std::vector<int>{0, 1};
  const auto size = static_cast<Eigen::Index>(axes.size() * n * n);
  constexpr double e = 1e-6;
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    Points<3> above = flat_sheet(n, n, sheet.ds, sheet.dr), below = above;
    const auto marker = static_cast<std::size_t>(column) / axes.size();
    const int axis = axes[static_cast<std::size_t>(column) % axes.size()];
    above[marker][axis] += e * sheet.ds;
    below[marker][axis] -= e * sheet.ds;
    const Points<3> more = forces_of(sheet, above), less = forces_of(sheet, below);
    for (Eigen::Index row = 0; row < size; ++row) {
      const auto k = static_cast<std::size_t>(row) / axes.size();
      const int d = axes[static_cast<std::size_t>(row) % axes.size()];
      matrix(row, column) =
          -(more[k][d] - less[k][d]) / (2 * e * sheet.ds) / (side.share(k / n) * side.share(k % n) * sheet.part_area());
    }
  }
  std::vector<double> result;
  const double rigid = motion == Motion::bending ? 50 : 0.5;
  const Eigen::VectorXcd eigenvalues = Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
  for (const auto& value : eigenvalues)
    if (value.real() > rigid) result.push_back(std::sqrt(value.real()));
  std::sort(result.begin(), result.end());
  return result;
}

// twist, saddle, breathing: exact values by Ritz's method
struct Reference {
  double nu, twist, saddle, breathing;
};
constexpr std::array references{Reference{0, 15.8226, 22.3733, 22.3733}, Reference{0.3, 13.4682, 19.5961, 24.2702}};

// Of the frequencies with 15 x 15 markers; `ratio` and `round_off` bound what is left of the error with 8 x 8.
void expect_frequencies(MarkerLattice lattice, double largest, double ratio, double round_off) {
  for (const Reference& exact : references) {
    const auto found = [&](std::size_t n) {
      return frequencies(square(n, exact.nu, Motion::bending, lattice), Motion::bending, energy_forces<3>);
    };
    const auto fine = found(15), coarse = found(8);
    const std::array<double, 3> known{exact.twist, exact.saddle, exact.breathing};
    for (std::size_t mode = 0; mode < 3; ++mode) {
      const double error = fine[mode] / known[mode] - 1, before = coarse[mode] / known[mode] - 1;
      std::printf("%s, nu %.1f, mode %zu: %.3f %% at 8 x 8, %.3f %% at 15 x 15\n", name_of(lattice).c_str(), exact.nu,
                  mode + 1, 100 * before, 100 * error);
      EXPECT_LT(std::abs(error), largest);
      EXPECT_LT(std::abs(error), ratio * std::abs(before) + round_off);
    }
  }
}

TEST(SheetEnergy, BendingFrequenciesOfAFreePlateConvergeAtSecondOrder) {
  expect_frequencies(MarkerLattice::centred, 0.005, 0.45, 1e-3);
}

TEST(SheetEnergy, BendingFrequenciesOfANodalPlateConvergeAtSecondOrder) {
  expect_frequencies(MarkerLattice::nodal, 0.025, 0.3, 0);
}

TEST(SheetEnergy, InPlaneFrequencyOfAFreePlate) {
  // u = sin(pi x): exact with frequency pi at nu = 0
  const auto nearest = [](const std::vector<double>& values, double wanted) {
    double best = 1e30;
    for (const double value : values)
      if (std::abs(value - wanted) < std::abs(best - wanted)) best = value;
    return best;
  };
  const double error =
      nearest(frequencies(square(11, 0, Motion::in_plane), Motion::in_plane, energy_forces<3>), M_PI) / M_PI - 1;
  std::printf("bar mode, nu 0: %.3f %% at 11 x 11\n", 100 * error);
  EXPECT_LT(std::abs(error), 0.0035);
}

TEST(LovePlate, BendingFrequenciesApproachThoseOfAFreePlate) {
  for (const Reference& exact : references) {
    const auto found = frequencies(square(12, exact.nu), Motion::bending, love_forces);
    const std::array<double, 3> known{exact.twist, exact.saddle, exact.breathing};
    for (std::size_t mode = 0; mode < 3; ++mode) {
      std::printf("love, nu %.1f, mode %zu: %.3f %% at 12 x 12\n", exact.nu, mode + 1,
                  100 * (found[mode] / known[mode] - 1));
      EXPECT_LT(std::abs(found[mode] / known[mode] - 1), 0.06);
    }
  }
}

TEST(LovePlate, HasNoNetForce) {
  const Points<3> x = crumpled_woven(8, 9, 5), forces = love_forces(square(9, 0.3), x);
  Point<3> force = Point<3>::Zero();
  double total = 0;
  for (const auto& f : forces) {
    force += f;
    total += f.norm();
  }
  EXPECT_LE(force.norm(), 1e-12 * total);
}

}  // namespace
}  // namespace washfsi::test
