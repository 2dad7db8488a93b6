// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/vreman.hpp"

#include <algorithm>
#include <cmath>

namespace washfsi {

double Vreman::operator()(const Gradient<3>& gradient) const {
  const double square = gradient.squaredNorm();
  if (!(square > 0)) return 0;
  const Gradient<3> scaled = gradient * sides_.asDiagonal(), b = scaled * scaled.transpose();
  const double minors = b(0, 0) * b(1, 1) - b(0, 1) * b(0, 1) + b(0, 0) * b(2, 2) - b(0, 2) * b(0, 2) +
                        b(1, 1) * b(2, 2) - b(1, 2) * b(1, 2);
  return constant_ * std::sqrt(std::max(minors, 0.0) / square);  // round-off can be negative
}

}  // namespace washfsi
