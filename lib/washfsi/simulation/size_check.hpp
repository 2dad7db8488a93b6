// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/simulation/case.hpp"

namespace washfsi {

/// Refuses a case whose grid or markers cannot fit into the memory of this machine or the range of PETSc's indices,
/// before any of it is made. Estimates are low; -check measures. Collective. Errors: InputError with the estimate.
template <int Dim>
void refuse_what_cannot_fit(MPI_Comm comm, const CaseOptions<Dim>& options);

}  // namespace washfsi
