// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/first_rank.hpp"

#include <exception>

#include "washfsi/support/collective.hpp"

namespace washfsi {

std::string problem_on_first_rank(MPI_Comm comm, const std::function<void()>& work) {
  std::string problem;
  if (rank_of(comm) == 0) {
    try {
      work();
    } catch (const std::exception& error) {
      problem = error.what();
    }
  }
  return from_first_rank(comm, problem);
}

}  // namespace washfsi
