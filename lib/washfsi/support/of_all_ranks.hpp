// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numeric>
#include <vector>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/contiguous_type.hpp"

namespace washfsi {

/// Returns the items of all ranks on each, in rank order; ranks may have any number of them. Items are copied bytewise.
/// Collective.
template <class Item>
std::vector<Item> of_all_ranks(MPI_Comm comm, const std::vector<Item>& mine) {
  const auto ranks = static_cast<std::size_t>(ranks_of(comm));
  std::vector<int> counts(ranks), starts(ranks, 0);
  const int count = static_cast<int>(mine.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
  std::exclusive_scan(counts.begin(), counts.end(), starts.begin(), 0);
  std::vector<Item> all(static_cast<std::size_t>(starts.back()) + static_cast<std::size_t>(counts.back()));
  const ContiguousType type(sizeof(Item), MPI_BYTE);
  MPI_Allgatherv(mine.data(), count, type, all.data(), counts.data(), starts.data(), type, comm);
  return all;
}

/// Returns the items that all ranks send to this one, in rank order; given are those that this one sends, in order of
/// the receiving ranks, and their number for each. Collective.
template <class Item>
std::vector<Item> sent_to_ranks(MPI_Comm comm, std::vector<Item> mine, const std::vector<int>& out) {
  const std::size_t ranks = out.size();
  if (ranks == 1) return mine;
  std::vector<int> in(ranks), out_at(ranks, 0), in_at(ranks, 0);
  MPI_Alltoall(out.data(), 1, MPI_INT, in.data(), 1, MPI_INT, comm);
  std::exclusive_scan(out.begin(), out.end(), out_at.begin(), 0);
  std::exclusive_scan(in.begin(), in.end(), in_at.begin(), 0);
  std::vector<Item> got(static_cast<std::size_t>(in_at.back()) + static_cast<std::size_t>(in.back()));
  const ContiguousType type(sizeof(Item), MPI_BYTE);
  MPI_Alltoallv(mine.data(), out.data(), out_at.data(), type, got.data(), in.data(), in_at.data(), type, comm);
  return got;
}

}  // namespace washfsi
