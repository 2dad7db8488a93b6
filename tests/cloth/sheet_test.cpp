// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/sheet.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/cloth/love.hpp"

namespace washfsi::test {
namespace {

constexpr double ds = 0.1, dr = 0.07;

// Woven cloth: different along warp and weft, Poisson's ratio and all stiffnesses present.
Sheet woven(std::size_t width) {
  return {.width = width,
          .ds = ds,
          .dr = dr,
          .ke_s = 50,
          .ke_r = 30,
          .ks = 8,
          .kb_s = 0.02,
          .kb_r = 0.05,
          .kt = 0.03,
          .poisson = 0.3,
          .damping = 0.2,
          .thickness = 1e-3};
}

Points<3> flat_sheet(std::size_t rows, std::size_t width, double along_s = ds, double along_r = dr) {
  Points<3> x;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < width; ++j)
      x.emplace_back(along_s * static_cast<double>(i), along_r * static_cast<double>(j), 0);
  return x;
}

Points<3> crumpled_sheet(std::size_t rows, std::size_t width, unsigned seed) {
  Points<3> x = flat_sheet(rows, width);
  const Points<3> moves = random_points<3>(x.size(), seed, 0.5 * dr);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += moves[k];
  return x;
}

Points<3> energy_forces(const Sheet& sheet, const Points<3>& x) {
  Points<3> forces(x.size(), Point<3>::Zero());
  add_energy_forces<3>(sheet, x, forces);
  return forces;
}

Points<3> love_forces(const Sheet& sheet, const Points<3>& x) {
  Points<3> forces(x.size(), Point<3>::Zero());
  add_love_forces(sheet, x, forces);
  return forces;
}

double energy_of(const Sheet& sheet, const Points<3>& x) {
  return elastic_energy<3>(sheet, x, 0, x.size());
}

Eigen::MatrixXd stiffness_of(const Sheet& sheet, const Points<3>& x, GeometricStiffness geometric) {
  const auto size = 3 * static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  add_energy_stiffness<3>(sheet, x, geometric, [&](std::size_t r, std::size_t c, const StiffnessBlock<3>& block) {
    matrix.block<3, 3>(3 * static_cast<Eigen::Index>(r), 3 * static_cast<Eigen::Index>(c)) += block;
  });
  return matrix;
}

// Sheets of all shapes, down to single rows and columns.
struct Shape {
  std::size_t rows, width;
};
constexpr std::array shapes{Shape{5, 4}, Shape{4, 5}, Shape{3, 3}, Shape{2, 4}, Shape{4, 2},
                            Shape{2, 2}, Shape{5, 1}, Shape{1, 5}, Shape{2, 1}, Shape{1, 1}};

TEST(SheetEnergy, ForceIsMinusItsGradient) {
  constexpr double e = 1e-6;
  for (const auto& [rows, width] : shapes) {
    const Sheet sheet = woven(width);
    Points<3> x = crumpled_sheet(rows, width, 3);
    const Points<3> forces = energy_forces(sheet, x);
    for (std::size_t k = 0; k < x.size(); ++k)
      for (int d = 0; d < 3; ++d) {
        const double kept = x[k][d];
        x[k][d] = kept + e;
        const double above = energy_of(sheet, x);
        x[k][d] = kept - e;
        const double below = energy_of(sheet, x);
        x[k][d] = kept;
        EXPECT_NEAR(forces[k][d], -(above - below) / (2 * e), 1e-8) << rows << " x " << width;
      }
  }
}

TEST(SheetEnergy, StiffnessIsTheJacobianOfItsForces) {
  constexpr double e = 1e-6;
  for (const auto& [rows, width] : shapes) {
    const Sheet sheet = woven(width);
    Points<3> x = crumpled_sheet(rows, width, 4);
    const Eigen::MatrixXd matrix = stiffness_of(sheet, x, GeometricStiffness::all);
    for (std::size_t k = 0; k < x.size(); ++k)
      for (int d = 0; d < 3; ++d) {
        const double kept = x[k][d];
        x[k][d] = kept + e;
        const Points<3> above = energy_forces(sheet, x);
        x[k][d] = kept - e;
        const Points<3> below = energy_forces(sheet, x);
        x[k][d] = kept;
        for (std::size_t l = 0; l < x.size(); ++l)
          for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(matrix(3 * static_cast<int>(l) + c, 3 * static_cast<int>(k) + d),
                        -(above[l] - below[l])[c] / (2 * e), 1e-6)
                << rows << " x " << width;
      }
  }
}

TEST(SheetEnergy, ForceRatesAreItsStiffnessTimesADirection) {
  for (const auto& [rows, width] : shapes) {
    const Points<3> x = crumpled_sheet(rows, width, 4), direction = random_points<3>(x.size(), 9);
    const Eigen::MatrixXd matrix = stiffness_of(woven(width), x, GeometricStiffness::all);
    Points<3> rates(x.size(), Point<3>::Zero());
    add_energy_force_rates<3>(woven(width), x, direction, rates);
    const auto size = 3 * static_cast<Eigen::Index>(x.size());
    const Eigen::VectorXd expected = -matrix * Eigen::Map<const Eigen::VectorXd>(direction[0].data(), size);
    EXPECT_LE((Eigen::Map<const Eigen::VectorXd>(rates[0].data(), size) - expected).norm(), 1e-12 * matrix.norm());
  }
}

TEST(SheetEnergy, StiffnessWithoutCompressionAndShearIsPositive) {
  const Points<3> x = crumpled_sheet(5, 6, 5);
  const auto least = [&](GeometricStiffness geometric) {
    const Eigen::MatrixXd matrix = stiffness_of(woven(6), x, geometric);
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()[0];
  };
  EXPECT_LT(least(GeometricStiffness::all), -1e-2);
  EXPECT_GT(least(GeometricStiffness::of_tension), -1e-10);
}

TEST(SheetEnergy, ACrumpledSheetHasNoNetForceAndTorque) {
  const Points<3> x = crumpled_sheet(12, 9, 5), forces = energy_forces(woven(9), x);
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
  Points<3> x = flat_sheet(6, 5);
  for (auto& place : x) place = turn * place + Point<3>(3, -1, 2);
  for (const auto& force : energy_forces(woven(5), x)) EXPECT_LE(force.norm(), 1e-12 * woven(5).ke_s);
}

// Work of the damping on random velocities, and none on a turning sheet.
TEST(SheetDamping, TakesEnergyOutAndSparesRigidMotion) {
  const Points<3> x = crumpled_sheet(5, 6, 7), u = random_points<3>(30, 8);
  Points<3> forces(30, Point<3>::Zero()), rigid(30, Point<3>::Zero()), turning;
  add_damping_forces<3>(woven(6), x, u, forces);
  double power = 0;
  for (std::size_t k = 0; k < 30; ++k) power += forces[k].dot(u[k]);
  EXPECT_LT(power, 0);
  for (const auto& place : x) turning.push_back(Point<3>(1, 2, 3) + Point<3>(-1, 3, 2).cross(place));
  add_damping_forces<3>(woven(6), x, turning, rigid);
  for (const auto& force : rigid) EXPECT_LE(force.norm(), 1e-11 * woven(6).ke_s);
}

// Uniform extension along s with free edges along r: N22 = 0 needs E22 = -nu_sr E11, and then no marker inside is
// pulled.
TEST(SheetEnergy, ContractsByPoissonsRatioWhereItsEdgesAreFree) {
  Sheet sheet = woven(6);
  sheet.kb_s = sheet.kb_r = sheet.kt = 0;
  const double nu_sr = sheet.poisson * std::sqrt(sheet.ke_s / sheet.ke_r);
  const double e11 = 0.01, e22 = -nu_sr * e11;
  const Points<3> x = flat_sheet(7, 6, ds * std::sqrt(1 + 2 * e11), dr * std::sqrt(1 + 2 * e22));
  const Points<3> forces = energy_forces(sheet, x);
  const double pull = sheet.ke_s * (1 - sheet.poisson * sheet.poisson) * e11 * std::sqrt(1 + 2 * e11) * dr;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k / 6;
    const Point<3> expected = i == 0 ? Point<3>(pull, 0, 0) : i == 6 ? Point<3>(-pull, 0, 0) : Point<3>::Zero();
    // half of the quads' share is missing in the outermost rows of edges along r
    if (i > 0 && i < 6) {
      EXPECT_LE((forces[k] - expected).norm(), 1e-12 * sheet.ke_s) << k;
    } else {
      EXPECT_NEAR(forces[k][0], expected[0], 1e-12 * sheet.ke_s) << k;
    }
  }
}

// A free square plate: side 1, mass 1 per area, Kb = 1, Kt = 1 - nu.
Sheet square(std::size_t n, double nu) {
  const double spacing = 1 / static_cast<double>(n);
  return {.width = n,
          .ds = spacing,
          .dr = spacing,
          .ke_s = 1,
          .ke_r = 1,
          .ks = 0.5 * (1 - nu),
          .kb_s = 1,
          .kb_r = 1,
          .kt = 1 - nu,
          .poisson = nu};
}

enum class Motion { bending, in_plane };

// Frequencies of small motions about the flat state from the eigenvalues of the forces, without the rigid motions.
template <class Forces>
std::vector<double> frequencies(std::size_t n, double nu, Motion motion, const Forces& forces_of) {
  Sheet sheet = square(n, nu);
  if (motion == Motion::in_plane) sheet.kb_s = sheet.kb_r = sheet.kt = 0;  // as thin as can be
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
      matrix(row, column) = -(more[k][d] - less[k][d]) / (2 * e * sheet.ds) / sheet.marker_area();
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

TEST(SheetEnergy, BendingFrequenciesOfAFreePlateConvergeAtSecondOrder) {
  for (const Reference& exact : references) {
    const auto coarse = frequencies(15, exact.nu, Motion::bending, energy_forces);
    const auto coarser = frequencies(8, exact.nu, Motion::bending, energy_forces);
    const std::array<double, 3> known{exact.twist, exact.saddle, exact.breathing};
    for (std::size_t mode = 0; mode < 3; ++mode) {
      const double error = coarse[mode] / known[mode] - 1, before = coarser[mode] / known[mode] - 1;
      std::printf("energy, nu %.1f, mode %zu: %.3f %% at 8 x 8, %.3f %% at 15 x 15\n", exact.nu, mode + 1, 100 * before,
                  100 * error);
      EXPECT_LT(std::abs(error), 0.005);
      EXPECT_LT(std::abs(error), 0.45 * std::abs(before) + 1e-3);
    }
  }
}

TEST(SheetEnergy, InPlaneFrequencyOfAFreePlate) {
  // u = sin(pi x): exact with frequency pi at nu = 0
  const auto nearest = [](const std::vector<double>& values, double wanted) {
    double best = 1e30;
    for (const double value : values)
      if (std::abs(value - wanted) < std::abs(best - wanted)) best = value;
    return best;
  };
  const double error = nearest(frequencies(11, 0, Motion::in_plane, energy_forces), M_PI) / M_PI - 1;
  std::printf("bar mode, nu 0: %.3f %% at 11 x 11\n", 100 * error);
  EXPECT_LT(std::abs(error), 0.0035);
}

TEST(LovePlate, BendingFrequenciesApproachThoseOfAFreePlate) {
  for (const Reference& exact : references) {
    const auto found = frequencies(12, exact.nu, Motion::bending, love_forces);
    const std::array<double, 3> known{exact.twist, exact.saddle, exact.breathing};
    for (std::size_t mode = 0; mode < 3; ++mode) {
      std::printf("love, nu %.1f, mode %zu: %.3f %% at 12 x 12\n", exact.nu, mode + 1,
                  100 * (found[mode] / known[mode] - 1));
      EXPECT_LT(std::abs(found[mode] / known[mode] - 1), 0.06);
    }
  }
}

TEST(LovePlate, HasNoNetForce) {
  const Points<3> x = crumpled_sheet(8, 9, 5), forces = love_forces(square(9, 0.3), x);
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
