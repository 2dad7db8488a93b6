// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/transform_layout.hpp"

#include <map>

#include <gtest/gtest.h>

namespace washfsi::test {
namespace {

template <int Dim>
Box<Dim> whole(const Index<Dim>& cells) {
  return {{}, cells};
}

// Every cell has one place with one rank, and this place is that of the cell.
template <int Dim>
void expect_each_cell_once(const TransformLayout<Dim>& layout, int ranks) {
  std::map<Index<Dim>, int> seen;
  for (int rank = 0; rank < ranks; ++rank) {
    const Box<Dim> box = layout.owned_by(rank);
    PetscInt size = 1;
    for (int d = 0; d < Dim; ++d) size *= box.upper[d] - box.lower[d];
    for (PetscInt place = 0; place < size; ++place) {
      const Index<Dim> cell = layout.cell(box, place);
      EXPECT_TRUE(box.contains(cell));
      EXPECT_EQ(layout.offset(box, cell), place);
      EXPECT_EQ(layout.owner(cell), rank);
      ++seen[cell];
    }
  }
  PetscInt count = 0;
  for_each<Dim>(whole<Dim>(layout.cells), [&](const Index<Dim>& cell) {
    EXPECT_EQ(seen[cell], 1);
    ++count;
  });
  EXPECT_EQ(static_cast<PetscInt>(seen.size()), count);
}

// Neighbours along what is transformed first lie side by side, and with one rank.
template <int Dim>
void expect_layouts_of_all_axes(const Index<Dim>& cells, int ranks) {
  std::array<int, Dim> transformed{};
  for (const auto& layout : transform_layouts<Dim>(cells, ranks)) {
    expect_each_cell_once(layout, ranks);
    for (int i = 0; i < layout.transformed; ++i) {
      ++transformed[layout.order[i]];
      EXPECT_EQ(layout.parts[layout.order[i]], 1);
    }
  }
  for (const int times : transformed) EXPECT_EQ(times, 1);
}

TEST(TransformLayout, LaysEachCellOnceAndTransformsEachAxisOnce) {
  for (const int ranks : {1, 2, 3, 5, 8, 12, 31}) {
    expect_layouts_of_all_axes<2>({7, 5}, ranks);
    expect_layouts_of_all_axes<3>({7, 6, 4}, ranks);
    expect_layouts_of_all_axes<3>({5, 9, 1}, ranks);
  }
}

int ranks_with_cells(const TransformLayout<3>& layout, int ranks) {
  int count = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    const Box<3> box = layout.owned_by(rank);
    if (box.upper[0] > box.lower[0] && box.upper[1] > box.lower[1] && box.upper[2] > box.lower[2]) ++count;
  }
  return count;
}

TEST(TransformLayout, CutsPencilsWhereSlabsWouldLeaveRanksIdle) {
  const Index<3> cells{8, 8, 8};
  EXPECT_EQ(transform_layouts<3>(cells, 8).size(), 2u);
  const auto pencils = transform_layouts<3>(cells, 64);
  ASSERT_EQ(pencils.size(), 3u);
  for (const auto& layout : pencils) EXPECT_EQ(ranks_with_cells(layout, 64), 64);
}

// An exchange between two layouts of pencils stays within rows of ranks, as long as all have as many cells.
TEST(TransformLayout, PencilsExchangeWithinRowsOfRanks) {
  const auto pencils = transform_layouts<3>({8, 8, 8}, 16);
  ASSERT_EQ(pencils.size(), 3u);
  for (std::size_t n = 1; n < pencils.size(); ++n)
    for (int rank = 0; rank < 16; ++rank) {
      std::map<int, int> from;
      for_each<3>(pencils[n].owned_by(rank), [&](const Index<3>& cell) { ++from[pencils[n - 1].owner(cell)]; });
      EXPECT_EQ(from.size(), 4u);
    }
}

}  // namespace
}  // namespace washfsi::test
