// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/placement/plate_mode.hpp"

#include <cmath>

#include "washfsi/support/eigensystem.hpp"

namespace washfsi {

namespace {

constexpr int terms = 12;  // along each side: frequencies of the first twelve modes to six digits

// Orthonormal Legendre polynomials with respect to the mean over -1..1.
Eigen::VectorXd polynomials(double x) {
  Eigen::VectorXd p(terms);
  p[0] = 1;
  p[1] = x;
  for (int n = 2; n < terms; ++n) p[n] = ((2 * n - 1) * x * p[n - 1] - (n - 1) * p[n - 2]) / n;
  for (int n = 0; n < terms; ++n) p[n] *= std::sqrt(2.0 * n + 1);
  return p;
}

// Column n: the derivative of polynomial n along a side of this length.
Eigen::MatrixXd derivative(double length) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(terms, terms);
  for (int n = 0; n < terms; ++n)
    for (int k = n - 1; k >= 0; k -= 2) matrix(k, n) = 2 / length * std::sqrt((2.0 * k + 1) * (2.0 * n + 1));
  return matrix;
}

Eigen::MatrixXd kronecker(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd result(a.rows() * b.rows(), a.cols() * b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      result.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  return result;
}

}  // namespace

PlateMode::PlateMode(const BendingModuli& bending, double length_s, double length_r, int mode) {
  const Eigen::MatrixXd ds = derivative(length_s), dr = derivative(length_r);
  const Eigen::MatrixXd dss = ds * ds, drr = dr * dr, one = Eigen::MatrixXd::Identity(terms, terms);
  constexpr double preference = 1 + 1e-6;  // two modes of equal frequency are told apart by their direction
  Eigen::MatrixXd stiffness = preference * bending.s * kronecker(dss.transpose() * dss, one) +
                              bending.r * kronecker(one, drr.transpose() * drr) +
                              2 * bending.twist * kronecker(ds.transpose() * ds, dr.transpose() * dr);
  const Eigen::MatrixXd mixed = kronecker(dss.transpose(), drr);
  stiffness += bending.cross * (mixed + mixed.transpose());
  const auto modes = eigensystem<Eigen::Dynamic>(stiffness);
  constexpr int rigid_motions = 3;
  const Eigen::Index number = rigid_motions - 1 + mode;
  frequency_ = std::sqrt(modes.values[number]);
  const Eigen::VectorXd shape = modes.vectors.col(number);
  Eigen::Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  coefficients_ = (shape[largest] > 0 ? 1 : -1) * shape.reshaped(terms, terms).transpose();
}

double PlateMode::operator()(double s, double r) const {
  return polynomials(s).dot(coefficients_ * polynomials(r));
}

}  // namespace washfsi
