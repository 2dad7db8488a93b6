// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/cloth/cloths.hpp"

#include <gtest/gtest.h>

#include "support/cloth_forces.hpp"
#include "support/random_points.hpp"
#include "washfsi/cloth/sheet_states.hpp"
#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

std::vector<ClothGroup<2>> two_groups(ElasticModel model, bool closed = false,
                                      MarkerLattice lattice = MarkerLattice::centred) {
  ClothGroup<2> large, small;
  large.name = "large";
  large.count = 2;
  large.markers = {11, 1};
  small.name = "small";
  small.count = 3;
  small.markers = {4, 1};
  large.model = small.model = model;
  large.sheet =
      small.sheet = {.ds = 0.1, .fabric = LinearFabric({.ke_s = 50, .kb_s = 0.02}), .damping = 0.1, .thickness = 1e-3};
  large.sheet.closed = closed;
  large.sheet.lattice = small.sheet.lattice = lattice;
  large.hold = Hold::middle;
  small.hold = Hold::edge;
  large.hold_stiffness = small.hold_stiffness = 300;
  return {large, small};
}

template <int Dim>
Points<Dim> part_of(const Cloths<Dim>& cloths, const Points<Dim>& values) {
  return Points<Dim>(values.begin() + cloths.begin(), values.begin() + cloths.end());
}

// The distributed forces, stresses and energies against those of each whole piece.
template <int Dim>
void expect_same_as_undistributed(const std::vector<ClothGroup<Dim>>& groups, const Points<Dim>& x) {
  const Cloths<Dim> all(PETSC_COMM_SELF, groups), mine(PETSC_COMM_WORLD, groups);
  ASSERT_EQ(all.marker_count(), static_cast<PetscInt>(x.size()));
  const Points<Dim> u = random_points<Dim>(x.size(), 12), anchors = random_points<Dim>(x.size(), 13);
  const auto part = [&](const Points<Dim>& values) { return part_of(mine, values); };
  const ClothForces<Dim> of_all(all, anchors), of_mine(mine, part(anchors));
  const Points<Dim> whole = of_all.of_places(x), forces = of_mine.of_places(part(x));
  const Points<Dim> whole_damping = of_all.of_velocities(x, u), damping = of_mine.of_velocities(part(x), part(u));
  const std::vector<MarkerState> whole_states = marker_states(all, x), states = marker_states(mine, part(x));
  for (std::size_t m = 0; m < mine.owned(); ++m) {
    const std::size_t global = m + static_cast<std::size_t>(mine.begin());
    EXPECT_EQ(forces[m], whole[global]);
    EXPECT_EQ(damping[m], whole_damping[global]);
    EXPECT_EQ(states[m].membrane_stress, whole_states[global].membrane_stress);
    EXPECT_EQ(states[m].bending_stress, whole_states[global].bending_stress);
    EXPECT_EQ(states[m].stretch, whole_states[global].stretch);
    EXPECT_EQ(states[m].shear_angle, whole_states[global].shear_angle);
  }
  const std::vector<double> energies = of_mine.elastic_energies(part(x)), whole_energies = of_all.elastic_energies(x);
  for (std::size_t g = 0; g < 2; ++g) EXPECT_NEAR(energies[g], whole_energies[g], 1e-12 * whole_energies[g]);
}

TEST(Cloths, EnergyFormDoesNotDependOnTheDistribution) {
  expect_same_as_undistributed<2>(two_groups(ElasticModel::energy), crumpled_fibre<2>(34, 0.1, 11));
}
TEST(Cloths, LoveFormDoesNotDependOnTheDistribution) {
  expect_same_as_undistributed<2>(two_groups(ElasticModel::love), crumpled_fibre<2>(34, 0.1, 11));
}

TEST(Cloths, ClosedClothDoesNotDependOnTheDistribution) {
  expect_same_as_undistributed<2>(two_groups(ElasticModel::energy, true), crumpled_fibre<2>(34, 0.1, 11));
}

// Each column of the matrix against differences of the forces, on all ranks at once.
TEST(Cloths, StiffnessIsTheJacobianOfTheForces) {
  for (const bool closed : {false, true}) {
    const Cloths<2> cloths(PETSC_COMM_WORLD, two_groups(ElasticModel::energy, closed));
    const Points<2> x = crumpled_fibre<2>(34, 0.1, 11);
    ClothForces<2> forces(cloths, part_of(cloths, x));
    petsc::Matrix matrix;
    forces.stiffness().lay_out(matrix);
    forces.stiffness().set(part_of(cloths, x), GeometricStiffness::all, 1, matrix);
    constexpr double e = 1e-6;
    for (std::size_t marker = 0; marker < 34; ++marker)
      for (int d = 0; d < 2; ++d) {
        Points<2> above = x, below = x;
        above[marker][d] += e;
        below[marker][d] -= e;
        const Points<2> more = forces.of_places(part_of(cloths, above));
        const Points<2> less = forces.of_places(part_of(cloths, below));
        const PetscInt column = 2 * static_cast<PetscInt>(marker) + d;
        for (PetscInt row = 2 * cloths.begin(); row < 2 * cloths.end(); ++row) {
          const auto m = static_cast<std::size_t>(row / 2 - cloths.begin());
          double value = 0;
          WASH_PETSC(MatGetValues(matrix, 1, &row, 1, &column, &value));
          EXPECT_NEAR(value, -(more[m] - less[m])[row % 2] / (2 * e), 2e-4) << "row " << row << ", column " << column;
        }
      }
  }
}

// One large sheet, cut wherever the ranks' shares end, and small ones.
std::vector<ClothGroup<3>> sheets(ElasticModel model, MarkerLattice lattice = MarkerLattice::centred) {
  ClothGroup<3> large, small;
  large.name = "large";
  large.markers = {9, 7};
  small.name = "small";
  small.count = 2;
  small.markers = {3, 4};
  const LinearModuli moduli{.ke_s = 50, .ke_r = 50, .ks = 20, .kb_s = 0.02, .kb_r = 0.02, .kt = 0.01, .poisson = 0.2};
  for (ClothGroup<3>* group : {&large, &small}) {
    group->model = model;
    group->sheet = {.width = static_cast<std::size_t>(group->markers[1]),
                    .ds = 0.1,
                    .dr = 0.1,
                    .fabric = LinearFabric(moduli),
                    .damping = 0.1,
                    .thickness = 1e-3,
                    .lattice = lattice};
    group->hold_stiffness = 300;
  }
  large.hold = Hold::corners;
  return {large, small};
}

Points<3> crumpled(const Cloths<3>& cloths) {
  Points<3> x = random_points<3>(static_cast<std::size_t>(cloths.marker_count()), 21, 0.03);
  for (const Piece& piece : cloths.pieces()) {
    const PetscInt width = cloths.groups()[piece.group].markers[1];
    for (PetscInt k = 0; k < piece.count; ++k) {
      const PetscInt row = k / width, column = k % width, marker = piece.first + k;
      x[static_cast<std::size_t>(marker)] += 0.1 * Point<3>(static_cast<double>(row), static_cast<double>(column), 0);
    }
  }
  return x;
}

TEST(Cloths, SheetsDoNotDependOnTheDistribution) {
  for (const ElasticModel model : {ElasticModel::energy, ElasticModel::love})
    expect_same_as_undistributed<3>(sheets(model), crumpled(Cloths<3>(PETSC_COMM_SELF, sheets(model))));
}

TEST(Cloths, NodalLatticesDoNotDependOnTheDistribution) {
  expect_same_as_undistributed<2>(two_groups(ElasticModel::energy, false, MarkerLattice::nodal),
                                  crumpled_fibre<2>(34, 0.1, 11));
  const std::vector<ClothGroup<3>> groups = sheets(ElasticModel::energy, MarkerLattice::nodal);
  expect_same_as_undistributed<3>(groups, crumpled(Cloths<3>(PETSC_COMM_SELF, groups)));
}

// The product of the matrix with random velocities against differences of the forces.
TEST(Cloths, StiffnessOfSheetsIsTheJacobianOfTheForces) {
  const Cloths<3> cloths(PETSC_COMM_WORLD, sheets(ElasticModel::energy));
  const Points<3> x = crumpled(cloths), u = random_points<3>(87, 23);
  const auto part = [&](const Points<3>& values) { return part_of(cloths, values); };
  ClothForces<3> forces(cloths, part(x));
  petsc::Matrix matrix;
  forces.stiffness().lay_out(matrix);
  forces.stiffness().set(part(x), GeometricStiffness::all, 1, matrix);
  petsc::Vector direction, result;
  WASH_PETSC(MatCreateVecs(matrix, direction.put(), result.put()));
  double* values = nullptr;
  WASH_PETSC(VecGetArray(direction, &values));
  for (std::size_t m = 0; m < cloths.owned(); ++m)
    for (int d = 0; d < 3; ++d) values[3 * m + static_cast<std::size_t>(d)] = part(u)[m][d];
  WASH_PETSC(VecRestoreArray(direction, &values));
  WASH_PETSC(MatMult(matrix, direction, result));
  constexpr double e = 1e-6;
  Points<3> above = x, below = x;
  for (std::size_t k = 0; k < x.size(); ++k) {
    above[k] += e * u[k];
    below[k] -= e * u[k];
  }
  const Points<3> more = forces.of_places(part(above)), less = forces.of_places(part(below));
  const double* found = nullptr;
  WASH_PETSC(VecGetArrayRead(result, &found));
  for (std::size_t m = 0; m < cloths.owned(); ++m)
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(found[3 * m + static_cast<std::size_t>(d)], -(more[m] - less[m])[d] / (2 * e), 1e-6);
  WASH_PETSC(VecRestoreArrayRead(result, &found));
}

TEST(Cloths, HoldsTheRightMarkersOfASheet) {
  ClothGroup<3> group;
  group.markers = {4, 3};
  const auto held = [&](Hold where) {
    group.hold = where;
    return group.held_markers();
  };
  EXPECT_EQ(held(Hold::first), (std::vector<PetscInt>{0, 1, 2}));
  EXPECT_EQ(held(Hold::edge), (std::vector<PetscInt>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(held(Hold::corners), (std::vector<PetscInt>{0, 2, 9, 11}));
  EXPECT_EQ(held(Hold::middle), (std::vector<PetscInt>{4, 7}));
  EXPECT_EQ(held(Hold::none), (std::vector<PetscInt>{}));
}

TEST(Cloths, DeadLoadsAddUp) {
  std::vector<ClothGroup<2>> groups = two_groups(ElasticModel::energy);
  groups[0].load = {1, -2};
  groups[0].end_force_first = {0.1, 0};
  groups[0].end_force_last = {0, 0.3};
  const Cloths<2> cloths(PETSC_COMM_WORLD, groups);
  std::vector<double> sum{0, 0};
  const ClothForces<2> forces(cloths, Points<2>(cloths.owned(), Point<2>::Zero()));
  for (const auto& force : forces.constant())
    for (int d = 0; d < 2; ++d) sum[static_cast<std::size_t>(d)] += force[d];
  sum = ordered_sum(PETSC_COMM_WORLD, sum);
  EXPECT_NEAR(sum[0], 2 * (1.1 + 0.1), 1e-12);
  EXPECT_NEAR(sum[1], 2 * (-2.2 + 0.3), 1e-12);
}

TEST(Cloths, MassesAndAreasAddUp) {
  const Cloths<2> cloths(PETSC_COMM_WORLD, two_groups(ElasticModel::energy));
  double mass = 0, area = 0;
  for (const double m : cloths.marker_masses()) mass += m;
  for (const double a : cloths.marker_areas()) area += a;
  EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, area), 3.4, 1e-12);
  EXPECT_NEAR(ordered_sum(PETSC_COMM_WORLD, mass), 3.4 * 0.093, 1e-12);
}

}  // namespace
}  // namespace washfsi::test
