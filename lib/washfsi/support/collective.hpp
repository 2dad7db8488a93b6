// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <mpi.h>

namespace washfsi {

int rank_of(MPI_Comm comm);
int ranks_of(MPI_Comm comm);

/// Sum over the ranks, added in rank order so that a repeated run gives the same bits. Collective.
double ordered_sum(MPI_Comm comm, double value);
std::vector<double> ordered_sum(MPI_Comm comm, const std::vector<double>& values);

/// Largest value of any rank. Collective.
double largest(MPI_Comm comm, double value);

/// True if it is true on any rank. Collective.
bool any_rank(MPI_Comm comm, bool mine);

/// Rank 0's text on every rank. Collective.
std::string from_first_rank(MPI_Comm comm, const std::string& text);

/// The content of a file that rank 0 reads, on every rank; nothing if it cannot be read. Collective.
std::optional<std::string> file_from_first_rank(MPI_Comm comm, const std::string& path);

/// A value with the place where it was found.
struct Located {
  double value = 0;
  double place[3] = {0, 0, 0};
};

/// The entry with the largest value of any rank (lowest rank on ties). Collective.
Located largest(MPI_Comm comm, const Located& mine);

}  // namespace washfsi
