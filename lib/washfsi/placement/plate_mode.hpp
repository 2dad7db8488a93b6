// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "washfsi/cloth/fabric_law.hpp"

namespace washfsi {

/// A bending mode of a free rectangular plate, by Ritz's method with products of Legendre polynomials.
class PlateMode {
 public:
  /// Mode 1, 2, ... in the order of frequency, of a plate with these moduli and side lengths [m].
  PlateMode(const BendingModuli& bending, double length_s, double length_r, int mode);

  /// Deflection at s and r from -1 to 1, with the rms 1 over the plate.
  double operator()(double s, double r) const;
  /// Angular frequency times the square root of the mass per area: the eigenvalue's root [sqrt(N m)/m2].
  double frequency() const { return frequency_; }

 private:
  Eigen::MatrixXd coefficients_;
  double frequency_ = 0;
};

}  // namespace washfsi
