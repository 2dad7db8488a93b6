// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include <mpi.h>

namespace washfsi {

/// Does on rank 0 what one process does best, and tells all ranks what went wrong; empty if nothing did. Collective.
std::string problem_on_first_rank(MPI_Comm comm, const std::function<void()>& work);

/// The same, where a problem is an error on all ranks.
template <class Error>
void on_first_rank(MPI_Comm comm, const std::function<void()>& work) {
  const std::string problem = problem_on_first_rank(comm, work);
  if (!problem.empty()) throw Error(problem);
}

}  // namespace washfsi
