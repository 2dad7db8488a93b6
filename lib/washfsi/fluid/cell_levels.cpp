// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/cell_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "washfsi/grid/partition.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi {

namespace {

constexpr double much_wider = 1.75;  // width over that of the narrowest cells from which cells are not coarsened

}  // namespace

PetscInt CellLine::cell_at(double x) const {
  return static_cast<PetscInt>(std::upper_bound(edges.begin() + 1, edges.end() - 1, x) - edges.begin()) - 1;
}

CellLine::Place CellLine::place(double x) const {
  const PetscInt cell = cell_at(x), n = cells();
  const bool below = x < middle(cell);
  PetscInt other = below ? cell - 1 : cell + 1;
  const bool outside = other < 0 || other == n;
  if (x == middle(cell) || (outside && !periodic)) return {{cell, cell}, {1, 0}};
  other = (other + n) % n;
  const double part = std::abs(x - middle(cell)) / to_next(below ? other : cell);
  return {{cell, other}, {1 - part, part}};
}

CellLine CellLine::coarsened() const {
  constexpr double same_ratio = 0.618;  // the last of three is as much wider than two as it is narrower by itself
  const PetscInt n = cells();
  const bool last_alone = n % 2 == 1 && width(n - 1) > 2 * same_ratio * width(0);
  CellLine coarse{{}, {}, periodic};
  for (PetscInt first = 0; first + 1 < n; first += 2) coarse.edges.push_back(edges[first]);
  if (n % 2 == 1 && last_alone) coarse.edges.push_back(edges[n - 1]);
  coarse.edges.push_back(edges[n]);
  for (const PetscInt end : part_ends) coarse.part_ends.push_back(std::min((end + 1) / 2, coarse.cells()));
  return coarse;
}

template <int Dim>
CellLevel<Dim>::CellLevel(const Grid<Dim>& grid) {
  for (int d = 0; d < Dim; ++d) {
    CellLine& line = lines_[d];
    line.periodic = grid.periodic(d);
    for (PetscInt i = 0; i <= grid.cells()[d]; ++i) line.edges.push_back(static_cast<double>(i) * grid.spacing()[d]);
    std::set<PetscInt> ends;
    for (int rank = 0; rank < ranks_of(grid.comm()); ++rank) ends.insert(grid.owned_by(rank).upper[d]);
    line.part_ends.assign(ends.begin(), ends.end());
  }
  count_cells();
}

template <int Dim>
void CellLevel<Dim>::count_cells() {
  int ranks = 1;
  for (const CellLine& line : lines_) ranks *= static_cast<int>(line.part_ends.size());
  starts_ = {0};
  for (int rank = 0; rank < ranks; ++rank)
    starts_.push_back(starts_.back() + static_cast<PetscInt>(owned_by(rank).count()));
}

template <int Dim>
Index<Dim> CellLevel<Dim>::cells() const {
  Index<Dim> cells;
  for (int d = 0; d < Dim; ++d) cells[d] = lines_[d].cells();
  return cells;
}

template <int Dim>
double CellLevel<Dim>::cell_count() const {
  double count = 1;
  for (const CellLine& line : lines_) count *= static_cast<double>(line.cells());
  return count;
}

template <int Dim>
Box<Dim> CellLevel<Dim>::owned_by(int rank) const {
  return cells_of_rank<Dim>(
      rank, [this](int axis) -> const auto& { return lines_[axis].part_ends; });
}

template <int Dim>
PetscInt CellLevel<Dim>::number(const Index<Dim>& cell) const {
  const int rank = rank_of_cell<Dim>(
      cell, [this](int axis) -> const auto& { return lines_[axis].part_ends; });
  const Box<Dim> box = owned_by(rank);
  PetscInt offset = 0;
  for (int d = Dim; d-- > 0;) offset = offset * (box.upper[d] - box.lower[d]) + cell[d] - box.lower[d];
  return starts_[rank] + offset;
}

template <int Dim>
CellLevel<Dim> CellLevel<Dim>::coarsened() const {
  double narrowest = std::numeric_limits<double>::max();
  for (const CellLine& line : lines_)
    if (line.cells() > 1) narrowest = std::min(narrowest, line.width(0));
  CellLevel coarse(*this);
  for (CellLine& line : coarse.lines_)
    if (line.cells() > 1 && line.width(0) < much_wider * narrowest) line = line.coarsened();
  coarse.count_cells();
  return coarse;
}

template class CellLevel<2>;
template class CellLevel<3>;

}  // namespace washfsi
