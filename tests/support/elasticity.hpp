// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/cloth/sheet.hpp"

namespace washfsi::test {

inline Points<3> flat_sheet(std::size_t rows, std::size_t width, double ds, double dr) {
  Points<3> x;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < width; ++j) x.emplace_back(ds * static_cast<double>(i), dr * static_cast<double>(j), 0);
  return x;
}

/// A sheet whose markers are moved at random, by at most half the spacing dr in each direction.
inline Points<3> crumpled_sheet(std::size_t rows, std::size_t width, double ds, double dr, unsigned seed) {
  Points<3> x = flat_sheet(rows, width, ds, dr);
  const Points<3> moves = random_points<3>(x.size(), seed, 0.5 * dr);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += moves[k];
  return x;
}

/// Woven cloth: the spacings of its markers [m], and its moduli, which differ along warp and weft; none is zero.
inline constexpr double woven_ds = 0.1, woven_dr = 0.07;
inline constexpr LinearModuli woven_moduli{
    .ke_s = 50, .ke_r = 30, .ks = 8, .kb_s = 0.02, .kb_r = 0.05, .kt = 0.03, .poisson = 0.3};

inline Points<3> crumpled_woven(std::size_t rows, std::size_t width, unsigned seed) {
  return crumpled_sheet(rows, width, woven_ds, woven_dr, seed);
}

/// Numbers of rows and of markers in a row: sheets of all shapes, down to single rows and columns.
struct Shape {
  std::size_t rows, width;
};
inline constexpr std::array shapes{Shape{5, 4}, Shape{4, 5}, Shape{3, 3}, Shape{2, 4}, Shape{4, 2},
                                   Shape{2, 2}, Shape{5, 1}, Shape{1, 5}, Shape{2, 1}, Shape{1, 1}};

template <int Dim>
Points<Dim> energy_forces(const Sheet& sheet, const Points<Dim>& x) {
  Points<Dim> forces(x.size(), Point<Dim>::Zero());
  add_energy_forces<Dim>(sheet, x, forces);
  return forces;
}

/// The sum of the blocks that add_blocks(add) adds, as a matrix.
template <int Dim, class AddBlocks>
Eigen::MatrixXd sum_of_blocks(std::size_t markers, const AddBlocks& add_blocks) {
  const auto size = Dim * static_cast<Eigen::Index>(markers);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  add_blocks([&](std::size_t r, std::size_t c, const StiffnessBlock<Dim>& block) {
    matrix.block<Dim, Dim>(Dim * static_cast<Eigen::Index>(r), Dim * static_cast<Eigen::Index>(c)) += block;
  });
  return matrix;
}

template <int Dim>
Eigen::MatrixXd stiffness_of(const Sheet& sheet, const Points<Dim>& x, GeometricStiffness geometric) {
  return sum_of_blocks<Dim>(x.size(),
                            [&](const AddBlock<Dim>& add) { add_energy_stiffness<Dim>(sheet, x, geometric, add); });
}

/// Values at each marker as one vector.
template <int Dim>
Eigen::Map<const Eigen::VectorXd> as_vector(const Points<Dim>& values) {
  return {values[0].data(), Dim * static_cast<Eigen::Index>(values.size())};
}

/// Calls compare(marker, direction, function(above), function(below)) for steps up and down of each coordinate.
template <int Dim, class Function, class Compare>
void for_each_step(Points<Dim> x, double step, const Function& function, const Compare& compare) {
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int d = 0; d < Dim; ++d) {
      const double kept = x[k][d];
      x[k][d] = kept + step;
      const auto above = function(x);
      x[k][d] = kept - step;
      const auto below = function(x);
      x[k][d] = kept;
      compare(k, d, above, below);
    }
}

/// Forces against central differences of energy(x).
template <int Dim, class Energy>
void expect_minus_gradient(const Points<Dim>& forces, const Energy& energy, const Points<Dim>& x, double tolerance) {
  constexpr double step = 1e-6;
  for_each_step<Dim>(x, step, energy, [&](std::size_t k, int d, double above, double below) {
    EXPECT_NEAR(forces[k][d], -(above - below) / (2 * step), tolerance) << "marker " << k << " of " << x.size();
  });
}

/// A matrix against central differences of -forces(x); and it is symmetric.
template <int Dim, class Forces>
void expect_jacobian(const Eigen::MatrixXd& matrix, const Forces& forces, const Points<Dim>& x, double tolerance) {
  constexpr double step = 1e-6;
  for_each_step<Dim>(x, step, forces, [&](std::size_t k, int d, const Points<Dim>& above, const Points<Dim>& below) {
    const Eigen::VectorXd column = -(as_vector<Dim>(above) - as_vector<Dim>(below)) / (2 * step);
    const Eigen::Index number = Dim * static_cast<Eigen::Index>(k) + d;
    EXPECT_LE((matrix.col(number) - column).template lpNorm<Eigen::Infinity>(), tolerance)
        << "marker " << k << " of " << x.size();
  });
  EXPECT_LE((matrix - matrix.transpose()).norm(), 1e-14 * matrix.norm());
}

/// Energy, forces, stiffness and force rates of a model as each other's derivatives.
template <int Dim, class Model>
void expect_consistent(const Model& model, const Points<Dim>& x, double force_tolerance, double stiffness_tolerance) {
  expect_minus_gradient<Dim>(
      model.forces(x), [&](const Points<Dim>& y) { return model.energy(y); }, x, force_tolerance);
  const Eigen::MatrixXd matrix = model.stiffness(x);
  expect_jacobian<Dim>(
      matrix, [&](const Points<Dim>& y) { return model.forces(y); }, x, stiffness_tolerance);
  const Points<Dim> direction = random_points<Dim>(x.size(), 9), rates = model.force_rates(x, direction);
  EXPECT_LE((as_vector<Dim>(rates) + matrix * as_vector<Dim>(direction)).norm(), 1e-12 * matrix.norm());
}

/// The elasticity of a sheet, for `expect_consistent`.
template <int Dim>
struct SheetModel {
  Sheet sheet;

  double energy(const Points<Dim>& x) const { return elastic_energy<Dim>(sheet, x, 0, x.size()); }
  Points<Dim> forces(const Points<Dim>& x) const { return energy_forces<Dim>(sheet, x); }
  Eigen::MatrixXd stiffness(const Points<Dim>& x) const { return stiffness_of<Dim>(sheet, x, GeometricStiffness::all); }
  Points<Dim> force_rates(const Points<Dim>& x, const Points<Dim>& direction) const {
    Points<Dim> rates(x.size(), Point<Dim>::Zero());
    add_energy_force_rates<Dim>(sheet, x, direction, rates);
    return rates;
  }
};

}  // namespace washfsi::test
