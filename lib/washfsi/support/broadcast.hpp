// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "washfsi/support/petsc.hpp"

namespace washfsi::petsc {

/// Returns the values that so many leaves of a star forest get from their roots. `type` is that of one value.
/// Collective.
template <class Values>
Values broadcast(PetscSF forest, MPI_Datatype type, const Values& roots, std::size_t leaves) {
  Values result(leaves);
  WASH_PETSC(PetscSFBcastBegin(forest, type, roots.data(), result.data(), MPI_REPLACE));
  WASH_PETSC(PetscSFBcastEnd(forest, type, roots.data(), result.data(), MPI_REPLACE));
  return result;
}

}  // namespace washfsi::petsc
