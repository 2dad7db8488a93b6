// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace washfsi {

/// Eigenvalues of a symmetric matrix, the least first, and its unit eigenvectors as columns in the same order.
template <int Size>
struct Eigensystem {
  Eigen::Matrix<double, Size, 1> values;
  Eigen::Matrix<double, Size, Size> vectors;
};

/// Reads the lower half of a symmetric matrix; Size is 2, 3 or Eigen::Dynamic. Eigen's solver takes ten seconds to
/// compile, so it is compiled in this source alone.
template <int Size>
Eigensystem<Size> eigensystem(const Eigen::Matrix<double, Size, Size>& symmetric);

}  // namespace washfsi
