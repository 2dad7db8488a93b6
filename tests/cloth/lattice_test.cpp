// SPDX-License-Identifier: BSD-3-Clause
//
// What the markers of the centred and of the nodal lattice stand for.
#include <gtest/gtest.h>

#include "support/cloth_forces.hpp"
#include "support/elasticity.hpp"
#include "washfsi/cloth/sheet_states.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

constexpr std::array both{MarkerLattice::centred, MarkerLattice::nodal};

// 0.9 x 0.7 m2 of woven cloth, in the plane 0.9 m.
template <int Dim>
ClothGroup<Dim> woven(MarkerLattice lattice, PetscInt rows, PetscInt width) {
  ClothGroup<Dim> group;
  group.name = "towel";
  group.count = 2;
  group.markers = {rows, width};
  group.size = {0.9, Dim == 2 ? 1 : 0.7};
  group.sheet.lattice = lattice;
  group.sheet.width = static_cast<std::size_t>(width);
  group.sheet.ds = group.size[0] / group.row(0).parts();
  group.sheet.dr = group.size[1] / group.row(1).parts();
  group.sheet.fabric = LinearFabric(woven_moduli);
  group.sheet.thickness = 1e-3;
  return group;
}

TEST(MarkerRow, NodalMarkersBeginAndEndOnTheEdges) {
  const MarkerRow centred(MarkerLattice::centred, 4), nodal(MarkerLattice::nodal, 5);
  const std::array shares{0.5, 1.0, 1.0, 1.0, 0.5};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(nodal.place(k), static_cast<double>(k) / 4);
    EXPECT_EQ(nodal.share(k), shares[k]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(centred.place(k), (static_cast<double>(k) + 0.5) / 4);
    EXPECT_EQ(centred.share(k), 1);
  }
  EXPECT_EQ(nodal.parts(), centred.parts());
}

TEST(MarkerRow, ASingleMarkerHasAllOfTheSide) {
  for (const MarkerLattice lattice : both) {
    const MarkerRow row(lattice, 1);
    EXPECT_EQ(row.parts(), 1);
    EXPECT_EQ(row.share(0), 1);
    EXPECT_EQ(row.place(0), 0.5);
  }
}

template <int Dim>
void expect_whole_areas_and_masses(PetscInt width) {
  for (const MarkerLattice lattice : both) {
    const ClothGroup<Dim> group = woven<Dim>(lattice, 7, width);
    const Cloths<Dim> cloths(PETSC_COMM_WORLD, {group});
    double mass = 0, area = 0;
    for (std::size_t m = 0; m < cloths.owned(); ++m) {
      mass += cloths.marker_masses()[m];
      area += cloths.marker_areas()[m];
      EXPECT_EQ(cloths.marker_areas()[m], cloths.marker_shares()[m] * group.sheet.part_area());
    }
    const double whole = 2 * group.size[0] * group.size[1];
    EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, area), whole, 1e-14 * whole);
    EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, mass), group.excess_mass * whole, 1e-14 * whole);
  }
}

TEST(Lattice, AreasAndMassesAddUpToThoseOfTheCloth) {
  expect_whole_areas_and_masses<2>(1);
  expect_whole_areas_and_masses<3>(1);
  expect_whole_areas_and_masses<3>(5);
}

TEST(Lattice, NodalEdgesHaveHalvesAndCornersQuarters) {
  const ClothGroup<3> sheet = woven<3>(MarkerLattice::nodal, 3, 4), centred = woven<3>(MarkerLattice::centred, 3, 4);
  const std::array expected{0.25, 0.5, 0.5, 0.25, 0.5, 1.0, 1.0, 0.5, 0.25, 0.5, 0.5, 0.25};
  for (PetscInt k = 0; k < 12; ++k) {
    EXPECT_EQ(sheet.marker_share(k), expected[static_cast<std::size_t>(k)]);
    EXPECT_EQ(centred.marker_share(k), 1);
  }
}

TEST(Lattice, DeadLoadsAddUp) {
  for (const MarkerLattice lattice : both) {
    ClothGroup<3> group = woven<3>(lattice, 4, 3);
    group.load = {0, 0, 2};
    group.end_force_first = {1, 0, 0};
    group.end_force_last = {0, 4, 0};
    const Cloths<3> cloths(PETSC_COMM_WORLD, {group});
    Points<3> loads(cloths.owned(), Point<3>::Zero());
    DeadLoads<3>(cloths, Point<3>(0, 0, -10)).add_force({}, {}, loads);
    std::vector<double> sum(3, 0.0);
    for (const auto& load : loads)
      for (std::size_t d = 0; d < 3; ++d) sum[d] += load[static_cast<Eigen::Index>(d)];
    sum = ordered_sum(PETSC_COMM_WORLD, sum);
    EXPECT_NEAR(sum[0], 2, 1e-14);
    EXPECT_NEAR(sum[1], 8, 1e-14);
    EXPECT_NEAR(sum[2], 2 * 0.63 * (2 - 10 * group.excess_mass), 1e-14);
  }
}

TEST(NodalSheet, ForcesAndStiffnessAreItsDerivatives) {
  for (const auto& [rows, width] : shapes) {
    const Sheet sheet = woven<3>(MarkerLattice::nodal, static_cast<PetscInt>(rows), static_cast<PetscInt>(width)).sheet;
    expect_consistent<3>(SheetModel<3>{sheet}, crumpled_sheet(rows, width, sheet.ds, sheet.dr, 3), 1e-7, 1e-6);
  }
  const Sheet fibre = woven<2>(MarkerLattice::nodal, 7, 1).sheet;
  expect_consistent<2>(SheetModel<2>{fibre}, crumpled_fibre<2>(7, fibre.ds, 3), 1e-7, 1e-4);
}

// Tangents X_s and X_r, the same everywhere.
struct Strained {
  Point<3> a{1.05, 0.02, 0.1}, b{0.08, 0.97, -0.03};
  double e11 = 0.5 * (a.squaredNorm() - 1), e22 = 0.5 * (b.squaredNorm() - 1), shear = a.dot(b);
  double coupling = woven_moduli.poisson * std::sqrt(woven_moduli.ke_s * woven_moduli.ke_r);

  Points<3> places(const Sheet& sheet, std::size_t rows) const {
    Points<3> x;
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < sheet.width; ++j)
        x.push_back(sheet.ds * static_cast<double>(i) * a + sheet.dr * static_cast<double>(j) * b);
    return x;
  }
  double energy_per_area() const {
    return 0.5 * woven_moduli.ke_s * e11 * e11 + 0.5 * woven_moduli.ke_r * e22 * e22 + coupling * e11 * e22 +
           0.5 * woven_moduli.ks * shear * shear;
  }
  // Through lines of constant s and of constant r, per length.
  Point<3> flux_s() const { return (woven_moduli.ke_s * e11 + coupling * e22) * a + woven_moduli.ks * shear * b; }
  Point<3> flux_r() const { return (woven_moduli.ke_r * e22 + coupling * e11) * b + woven_moduli.ks * shear * a; }
};

TEST(NodalSheet, HasTheEnergyOfAUniformStrainAndShear) {
  const Strained strained;
  for (const auto& [rows, width] : {std::array{2, 2}, std::array{5, 4}, std::array{3, 6}}) {
    const Sheet sheet = woven<3>(MarkerLattice::nodal, rows, width).sheet;
    const Points<3> x = strained.places(sheet, static_cast<std::size_t>(rows));
    EXPECT_NEAR(elastic_energy<3>(sheet, x, 0, x.size()), 0.63 * strained.energy_per_area(), 1e-13);
  }
}

// What pulls at an edge is what acts through it: the whole of a side on a corner is half an edge along each.
TEST(NodalSheet, AUniformStrainPullsAtItsEdgesOnly) {
  const Strained strained;
  const ClothGroup<3> group = woven<3>(MarkerLattice::nodal, 5, 4);
  const Sheet& sheet = group.sheet;
  const Points<3> forces = energy_forces<3>(sheet, strained.places(sheet, 5));
  const auto side = [](std::size_t k, std::size_t last) { return k == 0 ? 1.0 : k == last ? -1.0 : 0.0; };
  for (std::size_t k = 0; k < 20; ++k) {
    const std::size_t i = k / 4, j = k % 4;
    const Point<3> expected = side(i, 4) * group.row(1).share(j) * sheet.dr * strained.flux_s() +
                              side(j, 3) * group.row(0).share(i) * sheet.ds * strained.flux_r();
    EXPECT_LE((forces[k] - expected).norm(), 1e-13 * woven_moduli.ke_s) << k;
  }
}

TEST(NodalSheet, AUniformStrainGivesTheSameStressEverywhere) {
  const Strained strained;
  const Sheet sheet = woven<3>(MarkerLattice::nodal, 5, 4).sheet;
  const double n11 = std::abs(woven_moduli.ke_s * strained.e11 + strained.coupling * strained.e22) / sheet.thickness;
  const double n22 = std::abs(woven_moduli.ke_r * strained.e22 + strained.coupling * strained.e11) / sheet.thickness;
  const double n12 = std::abs(woven_moduli.ks * strained.shear) / sheet.thickness;
  for (const MarkerState& state : marker_states<3>(sheet, strained.places(sheet, 5))) {
    EXPECT_NEAR(state.membrane_stress[ss], n11, 1e-9);
    EXPECT_NEAR(state.membrane_stress[rr], n22, 1e-9);
    EXPECT_NEAR(state.membrane_stress[sr], n12, 1e-9);
  }
}

}  // namespace
}  // namespace washfsi::test
