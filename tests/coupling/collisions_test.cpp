// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"
#include "support/random_points.hpp"
#include "washfsi/contact/barrier.hpp"
#include "washfsi/coupling/coupling_operations.hpp"

namespace washfsi::test {
namespace {

// Short fibres in a periodic box of 10 cm, without water, that fly about without friction.
CaseOptions<2> flying_fibres() {
  CaseOptions<2> options = fibre_in_water(0.3, 0);
  options.model.grid.shape.cells = {16, 16};
  options.model.grid.shape.upper = {0.1, 0.1};
  options.model.medium = Medium::none;
  options.model.surrounding_forces.push_back(Barrier<2>::maker({.stiffness = 1e3, .friction = 0}));
  const ClothGroup<2> fibre = options.model.cloths[0];
  options.model.cloths.clear();
  options.placements.clear();
  for (int n = 0; n < 8; ++n) {
    ClothGroup<2> group = fibre;
    group.name = "fibre" + std::to_string(n);
    group.markers = {4, 1};
    group.size = {0.03, 1};
    group.sheet.ds = 0.0075;
    group.sheet.fabric = LinearFabric({.ke_s = 100, .kb_s = 1e-4});
    options.model.cloths.push_back(group);
    PlacementOptions<2> placement;
    const int column = n % 2, row = n / 2;
    placement.center = {0.03 + 0.045 * column, 0.0125 + 0.025 * row};
    options.placements.push_back(placement);
  }
  return options;
}

struct Energies {
  double all, of_contact;
};

Energies energies_of(const System<2>& system) {
  const auto& [model, state, step] = system;
  double kinetic = 0;
  for (std::size_t m = 0; m < state.velocities.size(); ++m)
    kinetic += 0.5 * model.cloths.marker_masses()[m] * state.velocities[m].squaredNorm();
  const auto sum = [](const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); };
  const double stored = sum(model.forces.energies(state.positions)),
               elastic = sum(model.forces.elastic_energies(state.positions));
  return {ordered_sum(model.grid.comm(), kinetic) + stored, stored - elastic};
}

struct Flight {
  int collisions = 0;
  double start, end, most = 0, largest_rise = 0, largest_change = 0;  ///< of energy
};

// Collisions are counted when contact begins and nothing else is in contact: there are more.
Flight fly(const std::string& scheme, double dt, int most_steps, int enough) {
  const auto system = start_system<2>(PETSC_COMM_WORLD, flying_fibres(), {});
  const Points<2> directions = random_points<2>(8, 5);
  for (std::size_t m = 0; m < system->state.velocities.size(); ++m)
    system->state.velocities[m] = directions[system->model.cloths.group_number(m)].normalized();
  CouplingOptions coupling;
  coupling.scheme = scheme;
  coupling.scheme_given = true;
  coupling.tolerance = 1e-10;
  const auto advance = make_coupling_scheme<2>(coupling, *system);
  Energies before = energies_of(*system);
  Flight flight{.start = before.all, .end = before.all};
  for (int n = 0; n < most_steps && flight.collisions < enough; ++n) {
    advance->advance(*system, dt);
    const Energies now = energies_of(*system);
    const double touching = 1e-9 * flight.start;
    if (now.of_contact > touching && before.of_contact <= touching) ++flight.collisions;
    flight.most = std::max(flight.most, now.all);
    flight.largest_rise = std::max(flight.largest_rise, now.all - before.all);
    flight.largest_change = std::max(flight.largest_change, std::abs(now.all - flight.start));
    before = now;
  }
  flight.end = before.all;
  return flight;
}

TEST(Collisions, KeepTheEnergyInExplicitSteps) {
  const Flight flight = fly("explicit", 2.5e-5, 1000000, 1000);
  EXPECT_EQ(flight.collisions, 1000);
  EXPECT_LE(std::abs(flight.end - flight.start), 1e-3 * flight.start);
  std::cout << flight.collisions << " collisions: energy changed by " << flight.end / flight.start - 1 << ", at most "
            << flight.largest_change / flight.start << "\n";
}

// Backward Euler takes energy out; only where the potential is not convex, as when facets turn, may a step give some of
// that back.
TEST(Collisions, TakeEnergyOutInImplicitSteps) {
  const Flight flight = fly("implicit", 1e-3, 2000, 1000);
  EXPECT_GE(flight.collisions, 20);
  EXPECT_LE(flight.largest_rise, 1e-3 * flight.start);
  EXPECT_LE(flight.most, flight.start);
  EXPECT_LT(flight.end, 0.5 * flight.start);
  std::cout << flight.collisions << " collisions: energy left " << flight.end / flight.start << ", largest rise "
            << flight.largest_rise / flight.start << "\n";
}

}  // namespace
}  // namespace washfsi::test
