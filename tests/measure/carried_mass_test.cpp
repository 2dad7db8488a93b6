// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/measure/carried_mass.hpp"

#include <gtest/gtest.h>

#include "support/fibre_in_water.hpp"

namespace washfsi::test {
namespace {

/// A fibre of 0.2 m and 0.1 kg/m2, straight along x, with its middle 5 cm above that of the box, all of it moving with
/// (3, 4) m/s.
CarriedMass of_moving_fibre(Medium medium, MassCarrier carrier) {
  ModelOptions<2> options = fibre_in_water(0.1, 0).model;
  options.medium = medium;
  options.cloth.mass_carrier = carrier;
  options.cloths[0].velocity = {3, 4};
  const auto along_x = [](const Model<2>& model) {
    Points<2> places;
    for (PetscInt m = 0; m < model.cloths.marker_count(); ++m)
      places.emplace_back(0.06 + 0.01 * (static_cast<double>(m) + 0.5), 0.21);
    return places;
  };
  const System<2> system(PETSC_COMM_WORLD, options, {}, along_x);
  return CarriedMass::of(system);
}

TEST(CarriedMass, HasTheMotionOfTheClothsThatCarryTheirMass) {
  const std::vector<std::pair<Medium, MassCarrier>> cases{
      {Medium::water, MassCarrier::cloth}, {Medium::none, MassCarrier::cloth}, {Medium::none, MassCarrier::water}};
  for (const auto& [medium, carrier] : cases) {
    const CarriedMass mass = of_moving_fibre(medium, carrier);
    EXPECT_NEAR(mass.kinetic_energy, 0.5 * 0.02 * 25, 1e-14);
    EXPECT_NEAR(mass.angular_momentum, -0.02 * 0.05 * 3, 1e-15);
  }
}

TEST(CarriedMass, IsNoneWhereTheWaterCarriesIt) {
  const CarriedMass mass = of_moving_fibre(Medium::water, MassCarrier::water);
  EXPECT_EQ(mass.kinetic_energy, 0);
  EXPECT_EQ(mass.angular_momentum, 0);
}

}  // namespace
}  // namespace washfsi::test
