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

/// Of a symmetric matrix, of which the lower half is read; Size is 2, 3 or Eigen::Dynamic. Eigen's solver takes ten
/// seconds to compile, so it is compiled here alone.
template <int Size>
Eigensystem<Size> eigensystem(const Eigen::Matrix<double, Size, Size>& symmetric);

}  // namespace washfsi
