// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/equal_parts.hpp"

#include <algorithm>
#include <numeric>

namespace washfsi {

EqualParts::EqualParts(MPI_Comm comm, std::size_t count) : comm_(comm) {
  const auto ranks = static_cast<std::size_t>(ranks_of(comm)), rank = static_cast<std::size_t>(rank_of(comm));
  std::vector<long> counts(ranks), starts(ranks + 1, 0);
  const auto mine = static_cast<long>(count);
  MPI_Allgather(&mine, 1, MPI_LONG, counts.data(), 1, MPI_LONG, comm);
  std::partial_sum(counts.begin(), counts.end(), starts.begin() + 1);
  const auto part_start = [&](std::size_t part) {
    return starts.back() * static_cast<long>(part) / static_cast<long>(ranks);
  };
  const auto in_common = [&](std::size_t owner, std::size_t part) {
    const long first = std::max(starts[owner], part_start(part));
    return static_cast<int>(std::max(0L, std::min(starts[owner + 1], part_start(part + 1)) - first));
  };
  for (std::size_t other = 0; other < ranks; ++other) {
    sent_.push_back(in_common(rank, other));
    received_.push_back(in_common(other, rank));
  }
}

std::vector<double> EqualParts::to_parts(const double* values, int width) const {
  return exchanged(values, width, sent_, received_);
}

std::vector<double> EqualParts::to_owners(const std::vector<double>& values) const {
  return exchanged(values.data(), 1, received_, sent_);
}

std::vector<double> EqualParts::exchanged(const double* values, int width, const std::vector<int>& sent,
                                          const std::vector<int>& received) const {
  const auto of_items = [width](std::vector<int> counts) {
    for (int& count : counts) count *= width;
    return counts;
  };
  const auto starts_of = [](const std::vector<int>& counts) {
    std::vector<int> starts(counts.size());
    std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
    return starts;
  };
  const std::vector<int> out = of_items(sent), in = of_items(received), out_at = starts_of(out), in_at = starts_of(in);
  std::vector<double> result(static_cast<std::size_t>(in_at.back() + in.back()));
  MPI_Alltoallv(values, out.data(), out_at.data(), MPI_DOUBLE, result.data(), in.data(), in_at.data(), MPI_DOUBLE,
                comm_);
  return result;
}

}  // namespace washfsi
