// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/transform_layout.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace washfsi {

namespace {

// First layer of a part of n layers; n for the part after the last. The cuts are DMDA's, so that slabs need not move.
PetscInt start_of(PetscInt n, int part, int parts) {
  return n / parts * part + std::min<PetscInt>(part, n % parts);
}

int part_of(PetscInt n, PetscInt layer, int parts) {
  int part = static_cast<int>(layer * parts / n);
  while (start_of(n, part, parts) > layer) --part;
  return part;
}

}  // namespace

template <int Dim>
Box<Dim> TransformLayout<Dim>::owned_by(int rank) const {
  Box<Dim> box{};
  for (int d = 0; d < Dim; ++d) {
    box.lower[d] = start_of(cells[d], rank % parts[d], parts[d]);
    box.upper[d] = start_of(cells[d], rank % parts[d] + 1, parts[d]);
    rank /= parts[d];
  }
  return rank == 0 ? box : Box<Dim>{};
}

template <int Dim>
int TransformLayout<Dim>::owner(const Index<Dim>& cell) const {
  int rank = 0;
  for (int d = Dim; d-- > 0;) rank = rank * parts[d] + part_of(cells[d], cell[d], parts[d]);
  return rank;
}

template <int Dim>
PetscInt TransformLayout<Dim>::offset(const Box<Dim>& box, const Index<Dim>& cell) const {
  PetscInt offset = 0;
  for (int i = Dim; i-- > 0;) {
    const int axis = order[i];
    offset = offset * (box.upper[axis] - box.lower[axis]) + cell[axis] - box.lower[axis];
  }
  return offset;
}

template <int Dim>
Index<Dim> TransformLayout<Dim>::cell(const Box<Dim>& box, PetscInt offset) const {
  Index<Dim> cell{};
  for (const int axis : order) {
    const PetscInt width = box.upper[axis] - box.lower[axis];
    cell[axis] = box.lower[axis] + offset % width;
    offset /= width;
  }
  return cell;
}

namespace {

// Numbers of parts along two axes, none without cells: as many as possible, then as equal as possible.
std::pair<int, int> most_even_parts(int ranks, PetscInt first_most, PetscInt second_most) {
  std::pair<int, int> best{1, 1};
  for (int first = 1; first <= std::min<PetscInt>(ranks, first_most); ++first) {
    const int second = static_cast<int>(std::min<PetscInt>(ranks / first, second_most));
    const int gained = first * second - best.first * best.second;
    if (gained > 0 || (gained == 0 && std::abs(first - second) < std::abs(best.first - best.second)))
      best = {first, second};
  }
  return best;
}

}  // namespace

TransformLayouts<3> pencil_layouts(const Index<3>& cells, int ranks) {
  const auto [p, q] = most_even_parts(ranks, std::min(cells[0], cells[1]), std::min(cells[1], cells[2]));
  return {{cells, {1, p, q}, {0, 1, 2}, 1}, {cells, {p, 1, q}, {1, 0, 2}, 1}, {cells, {p, q, 1}, {2, 0, 1}, 1}};
}

template <>
TransformLayouts<2> transform_layouts<2>(const Index<2>& cells, int ranks) {
  return {{cells, {1, ranks}, {0, 1}, 1}, {cells, {ranks, 1}, {1, 0}, 1}};
}

template <>
TransformLayouts<3> transform_layouts<3>(const Index<3>& cells, int ranks) {
  if (ranks == 1) return {{cells, {1, 1, 1}, {0, 1, 2}, 3}};
  if (ranks > std::min(cells[1], cells[2])) return pencil_layouts(cells, ranks);
  return {{cells, {1, 1, ranks}, {0, 1, 2}, 2}, {cells, {1, ranks, 1}, {2, 0, 1}, 1}};
}

template struct TransformLayout<2>;
template struct TransformLayout<3>;

}  // namespace washfsi
