// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/support/petsc.hpp"

namespace washfsi {

/// The least and the largest value of a vector.
struct VectorRange {
  double least = 0, most = 0;

  bool is_uniform() const { return least == most; }
};

/// Finds them. Collective.
inline VectorRange range_of(Vec vector) {
  VectorRange range;
  WASH_PETSC(VecMin(vector, nullptr, &range.least));
  WASH_PETSC(VecMax(vector, nullptr, &range.most));
  return range;
}

}  // namespace washfsi
