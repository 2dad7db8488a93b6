// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/immersed_boundary/marker_exchange.hpp"

#include <numeric>

#include "washfsi/support/broadcast.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

template <int Dim>
void MarkerExchange<Dim>::update(const Points<Dim>& positions) {
  std::vector<int> owners;
  owners.reserve(positions.size());
  for (const auto& position : positions) owners.push_back(grid_.owner(grid_.cell_of(position)));
  const bool changed = !forest_ || owners != cell_owner_;
  cell_owner_ = std::move(owners);
  if (any_rank(grid_.comm(), changed)) rebuild();
}

template <int Dim>
void MarkerExchange<Dim>::rebuild() {
  const auto ranks = static_cast<std::size_t>(ranks_of(grid_.comm()));
  std::vector<int> sent(ranks, 0), received(ranks, 0), sent_start(ranks, 0), received_start(ranks, 0);
  for (const int owner : cell_owner_) ++sent[owner];
  MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, grid_.comm());
  std::exclusive_scan(sent.begin(), sent.end(), sent_start.begin(), 0);
  std::exclusive_scan(received.begin(), received.end(), received_start.begin(), 0);

  std::vector<int> outgoing(cell_owner_.size()), next = sent_start;
  for (std::size_t m = 0; m < cell_owner_.size(); ++m) {
    int& slot = next[static_cast<std::size_t>(cell_owner_[m])];
    outgoing[slot] = static_cast<int>(m);
    ++slot;
  }
  here_ = static_cast<std::size_t>(std::accumulate(received.begin(), received.end(), 0));
  std::vector<int> incoming(here_);
  MPI_Alltoallv(outgoing.data(), sent.data(), sent_start.data(), MPI_INT, incoming.data(), received.data(),
                received_start.data(), MPI_INT, grid_.comm());

  // sorted by marker number, since ranks own ascending ranges: sums are taken in the same order each time
  std::vector<PetscSFNode> sources;
  sources.reserve(here_);
  for (std::size_t rank = 0; rank < ranks; ++rank)
    for (int i = received_start[rank]; i < received_start[rank] + received[rank]; ++i)
      sources.push_back({static_cast<PetscInt>(rank), incoming[i]});
  forest_ = petsc::star_forest(grid_.comm(), cell_owner_.size(), sources);
}

template <int Dim>
Points<Dim> MarkerExchange<Dim>::to_cells(const Points<Dim>& values) const {
  return petsc::broadcast(forest_, point_type_, values, here_);
}

template <int Dim>
std::vector<double> MarkerExchange<Dim>::to_cells(const std::vector<double>& values) const {
  return petsc::broadcast(forest_, MPI_DOUBLE, values, here_);
}

template <int Dim>
Points<Dim> MarkerExchange<Dim>::to_owners(const Points<Dim>& values) const {
  Points<Dim> result(cell_owner_.size(), Point<Dim>::Zero());
  WASH_PETSC(PetscSFReduceBegin(forest_, point_type_, values.data(), result.data(), MPI_REPLACE));
  WASH_PETSC(PetscSFReduceEnd(forest_, point_type_, values.data(), result.data(), MPI_REPLACE));
  return result;
}

template class MarkerExchange<2>;
template class MarkerExchange<3>;

}  // namespace washfsi
