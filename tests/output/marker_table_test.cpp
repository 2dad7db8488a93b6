// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/output/marker_table.hpp"

#include <gtest/gtest.h>

#include "support/lattice_group.hpp"
#include "support/scratch_folder.hpp"

namespace washfsi::test {
namespace {

// The lines of a table in which the first coordinate and velocity of marker m are m + 1, and the others 0.
template <int Dim>
std::vector<std::string> table_of(const std::vector<ClothGroup<Dim>>& groups) {
  const ScratchFolder folder;
  const Cloths<Dim> cloths(PETSC_COMM_WORLD, groups);
  Points<Dim> places;
  for (std::size_t m = 0; m < cloths.owned(); ++m)
    places.push_back(static_cast<double>(cloths.number_of(m) + 1) * Point<Dim>::UnitX());
  write_marker_table<Dim>(PETSC_COMM_WORLD, folder.file("cloth_final.csv"), cloths, places, places);
  return folder.lines("cloth_final.csv");
}

TEST(MarkerTable, NumbersTheClothsOfEachGroupAndTheirMarkers) {
  const std::vector<std::string> expected{"group,cloth,i,j,x,y,u,v", "# -,-,-,-,m,m,m/s,m/s", "sock,0,0,0,1,0,1,0",
                                          "sock,0,1,0,2,0,2,0",      "belt,0,0,0,3,0,3,0",    "belt,0,1,0,4,0,4,0",
                                          "belt,0,2,0,5,0,5,0",      "belt,1,0,0,6,0,6,0",    "belt,1,1,0,7,0,7,0",
                                          "belt,1,2,0,8,0,8,0"};
  EXPECT_EQ(table_of<2>({lattice_group<2>("sock", 1, {2, 1}), lattice_group<2>("belt", 2, {3, 1})}), expected);
}

// i along s, j along r, which is the faster one.
TEST(MarkerTable, HasPlacesOnTheLatticeOfASheet) {
  const std::vector<std::string> expected{"group,cloth,i,j,x,y,z,u,v,w", "# -,-,-,-,m,m,m,m/s,m/s,m/s",
                                          "towel,0,0,0,1,0,0,1,0,0",     "towel,0,0,1,2,0,0,2,0,0",
                                          "towel,0,0,2,3,0,0,3,0,0",     "towel,0,1,0,4,0,0,4,0,0",
                                          "towel,0,1,1,5,0,0,5,0,0",     "towel,0,1,2,6,0,0,6,0,0"};
  EXPECT_EQ(table_of<3>({lattice_group<3>("towel", 1, {2, 3})}), expected);
}

}  // namespace
}  // namespace washfsi::test
