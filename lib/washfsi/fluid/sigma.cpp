// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/sigma.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace washfsi {

Sigma::Sigma(double constant, const Point<3>& sides) : square_(std::pow(constant * std::cbrt(sides.prod()), 2)) {}

// Uses |det alpha| = sigma_1 sigma_2 sigma_3, which is exact where the least singular values are lost in round-off.
double Sigma::operator()(const Gradient<3>& gradient) const {
  Eigen::SelfAdjointEigenSolver<Gradient<3>> solver;
  solver.computeDirect(gradient.transpose() * gradient, Eigen::EigenvaluesOnly);
  const Point<3> s = solver.eigenvalues().cwiseMax(0).cwiseSqrt();  // the least first
  if (!(s[1] > 0)) return 0;
  return square_ * std::abs(gradient.determinant()) * (s[2] - s[1]) * (1 - s[0] / s[1]) / (s[2] * s[2] * s[2]);
}

}  // namespace washfsi
