// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/scheme/step_mobility.hpp"

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "support/random_points.hpp"
#include "washfsi/scheme/coupling_operations.hpp"

namespace washfsi::test {
namespace {

// This rank's part of random values of all markers.
Points<2> values_of(const Model<2>& model, unsigned seed) {
  const Points<2> all = random_points<2>(static_cast<std::size_t>(model.cloths.marker_count()), seed);
  return {all.begin() + model.cloths.begin(), all.begin() + model.cloths.end()};
}

// With water that moves cloth half as far as M says: right for the changes that were seen, and never less than the
// water does for any other, so that steps remain stable.
TEST(StepMobility, LearnsFromTheWaterWithoutFallingBelowIt) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, fibre_in_water(0.093, 0), {});
  Model<2>& model = system->model;
  const MPI_Comm comm = model.grid.comm();
  model.locate_cloth(system->state.positions);
  StepMobility<2> mobility(model);
  mobility.find(model, system->state.positions, 1, true);
  StepMobility<2> unchanged(model);
  unchanged.find(model, system->state.positions, 1, true);
  const auto water = [&](const Points<2>& forces) { return 0.5 * unchanged.times(forces); };
  std::vector<Points<2>> changes;
  for (unsigned seed = 1; seed < 4; ++seed) {
    const Points<2> change = values_of(model, seed);
    mobility.correct(change, mobility.times(change) - water(change));
    changes.push_back(change);
  }
  for (const Points<2>& change : changes) {
    const Points<2> expected = water(change);
    EXPECT_LE(norm(comm, mobility.times(change) - expected), 1e-10 * norm(comm, expected));
  }
  for (unsigned seed = 10; seed < 40; ++seed) {
    const Points<2> forces = values_of(model, seed);
    EXPECT_GE(dot(comm, forces, mobility.times(forces)), (1 - 1e-10) * dot(comm, forces, water(forces)));
  }
}

}  // namespace
}  // namespace washfsi::test
