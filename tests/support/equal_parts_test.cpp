// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/equal_parts.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "washfsi/support/petsc.hpp"

namespace washfsi::test {
namespace {

// The last rank has all places, or each has others.
Points<2> places_of(int rank, int ranks, bool even) {
  Points<2> places;
  const int count = even ? 5 + 3 * rank : rank + 1 == ranks ? 50 : 0;
  for (int n = 0; n < count; ++n) places.emplace_back(0.1 * n, rank);
  return places;
}

TEST(EqualParts, GivesEachPlaceItsValueAndEachRankAsMuchWork) {
  MPI_Comm comm = PETSC_COMM_WORLD;
  const int rank = rank_of(comm), ranks = ranks_of(comm);
  for (const bool even : {true, false}) {
    const Points<2> places = places_of(rank, ranks, even);
    double worked_out = 0;
    const std::vector<double> values = shared_values<2>(comm, places, [&](const Point<2>& place) {
      ++worked_out;
      return place[0] + 100 * place[1];
    });
    ASSERT_EQ(values.size(), places.size());
    for (std::size_t n = 0; n < places.size(); ++n) EXPECT_EQ(values[n], places[n][0] + 100 * places[n][1]);
    const double all = ordered_sum(comm, static_cast<double>(places.size()));
    EXPECT_LE(largest(comm, worked_out), std::ceil(all / ranks));
  }
}

TEST(EqualParts, AgreesWhereThereIsNothing) {
  EXPECT_TRUE(shared_values<3>(PETSC_COMM_WORLD, {}, [](const Point<3>&) { return 1.0; }).empty());
}

}  // namespace
}  // namespace washfsi::test
