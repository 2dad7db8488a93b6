// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include <mpi.h>

namespace washfsi {

/// Does work on rank 0 and returns the text of its error on all ranks; empty if there was none. Collective.
std::string problem_on_first_rank(MPI_Comm comm, const std::function<void()>& work);

/// Does work on rank 0 and throws its error on all ranks.
template <class Error>
void on_first_rank(MPI_Comm comm, const std::function<void()>& work) {
  const std::string problem = problem_on_first_rank(comm, work);
  if (!problem.empty()) throw Error(problem);
}

}  // namespace washfsi
