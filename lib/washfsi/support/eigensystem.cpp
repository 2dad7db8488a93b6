// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/eigensystem.hpp"

#include <Eigen/Eigenvalues>

namespace washfsi {

template <int Size>
Eigensystem<Size> eigensystem(const Eigen::Matrix<double, Size, Size>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

template Eigensystem<2> eigensystem(const Eigen::Matrix<double, 2, 2>&);
template Eigensystem<3> eigensystem(const Eigen::Matrix<double, 3, 3>&);
template Eigensystem<Eigen::Dynamic> eigensystem(const Eigen::MatrixXd&);

}  // namespace washfsi
