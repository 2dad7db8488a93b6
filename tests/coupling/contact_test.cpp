// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "washfsi/contact/body_contact.hpp"
#include "washfsi/shapes/primitives.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

// The deepest marker after a roller of 8 cm has started off towards a fibre and pushed it along for some cells [m].
double depth_before_a_roller(const std::string& scheme, Mobility mobility, double courant) {
  CaseOptions<2> options = fibre_in_water(0.093, 0);
  options.model.grid.shape.cells = {32, 64};
  options.model.grid.shape.upper = {0.32, 0.64};
  options.model.treatment.method = BodyMethod::mapping;
  options.model.surrounding_forces.push_back(BodyContact<2>::maker({.pressure = 2e4, .distance = 0.01}));
  std::vector<Body<2>> bodies(1);
  bodies[0].name = "roller";
  bodies[0].shape = std::make_unique<Sphere<2>>(0.04);
  bodies[0].motion.center = {0.16, 0.11};
  bodies[0].motion.translation = {0, 1};
  const auto system = start_system<2>(PETSC_COMM_WORLD, options, std::move(bodies));
  CouplingOptions coupling;
  coupling.scheme = scheme;
  coupling.mobility = mobility;
  coupling.order = 1;
  const auto advance = make_coupling_scheme<2>(coupling, *system);
  double deepest = 0;
  while (system->state.clock.time < 0.15) {
    advance->advance(*system, courant * 0.01);
    for (const Point<2>& place : system->state.positions)
      deepest = std::max(deepest, -nearest_distance<2>(system->model.body_list, place, system->state.clock.time));
  }
  return largest(PETSC_COMM_WORLD, deepest);
}

// However long the step: penalty contact is solved for together with the cloth's own forces.
TEST(Contact, KeepsTheClothBeforeARollerThatMovesIntoIt) {
  for (const double courant : {0.1, 0.5}) {
    EXPECT_EQ(depth_before_a_roller("semi_implicit", Mobility::matrix, courant), 0);
    EXPECT_EQ(depth_before_a_roller("semi_implicit", Mobility::row_sums, courant), 0);
  }
  EXPECT_EQ(depth_before_a_roller("explicit", Mobility::matrix, 0.05), 0);
}

}  // namespace
}  // namespace washfsi::test
