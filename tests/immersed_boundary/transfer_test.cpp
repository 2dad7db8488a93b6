// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/immersed_boundary/face_mobility.hpp"
#include "washfsi/immersed_boundary/mobility.hpp"
#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi::test {
namespace {

/// Sum of weight times distance^power over the points of a stencil, every or every second one.
double moment(DeltaKernel kernel, double width, double place, int power, int step = 1) {
  const AxisStencil stencil = AxisDelta(kernel, width).stencil(place);
  double sum = 0;
  for (int i = 0; i < stencil.count; ++i) {
    const PetscInt point = stencil.first + i;
    if (step == 2 && point % 2 != 0) continue;
    sum += stencil.weight[static_cast<std::size_t>(i)] * std::pow(static_cast<double>(point) - place, power);
  }
  return sum;
}

// Places within a cell.
std::vector<double> places_in_a_cell() {
  std::vector<double> places;
  for (int n = 0; n < 28; ++n) places.push_back(5 + 0.037 * n);
  return places;
}

TEST(Delta, WeightsSumToOneWhereverTheMarkerIs) {
  for (const double place : places_in_a_cell()) {
    for (const double width : {1.5, 2.0, 3.0, 4.0})
      EXPECT_NEAR(moment(DeltaKernel::cosine, width, place, 0), 1, 1e-14) << width << " at " << place;
    EXPECT_NEAR(moment(DeltaKernel::peskin, 2, place, 0), 1, 1e-14) << place;
    EXPECT_NEAR(moment(DeltaKernel::bao, 3, place, 0), 1, 1e-14) << place;
  }
}

// What their authors built these kernels from.
TEST(Delta, PeskinsAndBaosHaveTheirMoments) {
  const double second = 59.0 / 60 - std::sqrt(29.0) / 20;
  for (const double place : places_in_a_cell()) {
    for (const auto& [kernel, width] : {std::pair{DeltaKernel::peskin, 2.0}, {DeltaKernel::bao, 3.0}}) {
      EXPECT_NEAR(moment(kernel, width, place, 0, 2), 0.5, 1e-14) << place;
      EXPECT_NEAR(moment(kernel, width, place, 1), 0, 1e-14) << place;
    }
    EXPECT_NEAR(moment(DeltaKernel::bao, 3, place, 2), second, 1e-14) << place;
    EXPECT_NEAR(moment(DeltaKernel::bao, 3, place, 3), 0, 1e-13) << place;
  }
}

TEST(Delta, KernelsAreEvenAndContinuous) {
  for (const auto kernel : {DeltaKernel::cosine, DeltaKernel::peskin, DeltaKernel::bao})
    for (int n = 0; n < 3000; ++n) {
      const double x = 0.0005 + 0.001 * n;
      const double width = kernel == DeltaKernel::bao ? 3 : 2;
      const double here = regularised_delta(kernel, x, width);
      EXPECT_NEAR(here, regularised_delta(kernel, -x, width), 1e-14) << x;
      EXPECT_NEAR(here, regularised_delta(kernel, x + 0.001, width), 0.02) << x;
    }
}

/// A box of walls, slip sides and periodic sides with markers in it, each rank holding a part of them.
template <int Dim>
struct Tank {
  static GridShape<Dim> shape(PetscInt periodic_cells) {
    GridShape<Dim> shape;
    for (std::size_t d = 0; d < Dim; ++d) shape.cells[d] = 15 + static_cast<PetscInt>(d);
    shape.cells[0] = periodic_cells;
    shape.periodic[0] = true;
    shape.ghost_width = 3;
    return shape;
  }
  static typename Boundary<Dim>::Sides sides() {
    typename Boundary<Dim>::Sides sides;
    sides[1][1].kind = BoundaryKind::slip;
    return sides;
  }
  explicit Tank(const Points<Dim>& all, PetscInt periodic_cells = 15)
      : grid(PETSC_COMM_WORLD, shape(periodic_cells)), boundary(grid, sides()), transfer(grid, boundary, {}) {
    const std::size_t rank = static_cast<std::size_t>(rank_of(grid.comm())),
                      ranks = static_cast<std::size_t>(ranks_of(grid.comm()));
    for (std::size_t m = all.size() * rank / ranks; m < all.size() * (rank + 1) / ranks; ++m) {
      positions.push_back(all[m]);
      numbers.push_back(m);
    }
    transfer.locate(positions);
  }
  Points<Dim> mine(const Points<Dim>& all) const {
    Points<Dim> part;
    for (const std::size_t m : numbers) part.push_back(all[m]);
    return part;
  }
  Point<Dim> integral(Vec field) const {
    const ConstFaceView<Dim> view(grid.wide_face_dm(), field);
    std::vector<double> sums(Dim, 0.0);
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& face) {
      for (int c = 0; c < Dim; ++c) sums[static_cast<std::size_t>(c)] += view(face, c) * grid.cell_volume();
    });
    sums = ordered_sum(grid.comm(), sums);
    return Point<Dim>(sums.data());
  }

  Grid<Dim> grid;
  Boundary<Dim> boundary;
  Transfer<Dim> transfer;
  Points<Dim> positions;
  std::vector<std::size_t> numbers;
};

// Points of the unit box, up to its walls.
template <int Dim>
Points<Dim> places(std::size_t count) {
  Points<Dim> points = random_points<Dim>(count, 21, 0.4999);
  for (auto& point : points) point += Point<Dim>::Constant(0.5);
  return points;
}

template <int Dim>
Point<Dim> total(const Points<Dim>& forces) {
  Point<Dim> sum = Point<Dim>::Zero();
  for (const auto& force : forces) sum += force;
  return sum;
}

template <int Dim>
void expect_adjoint() {
  Tank<Dim> tank(places<Dim>(60));
  const Points<Dim> forces = tank.mine(random_points<Dim>(60, 22));
  const petsc::Vector u = tank.grid.face_vector(), f = tank.grid.face_vector();
  {
    const FaceView<Dim> view(tank.grid.wide_face_dm(), u);
    for (int c = 0; c < Dim; ++c)
      for_each<Dim>(tank.grid.inner_faces(c), [&](const Index<Dim>& face) {
        view(face, c) = std::sin(9.1 * tank.grid.face_center(face, c).sum() + c);
      });
  }
  tank.transfer.spread(forces, f);
  double on_grid = 0, on_cloth = 0;
  WASH_PETSC(VecDot(u, f, &on_grid));
  const petsc::LocalVector local(tank.grid.wide_face_dm(), u);
  tank.boundary.fill_homogeneous(local);
  const Points<Dim> velocities = tank.transfer.interpolate(local);
  for (std::size_t m = 0; m < forces.size(); ++m) on_cloth += forces[m].dot(velocities[m]);
  on_cloth = ordered_sum(tank.grid.comm(), on_cloth);
  EXPECT_NEAR(on_grid * tank.grid.cell_volume(), on_cloth, 1e-12 * std::max(1.0, std::abs(on_cloth)));
}

TEST(Transfer, SpreadIsTheAdjointOfInterpolateInThePlane) {
  expect_adjoint<2>();
}
TEST(Transfer, SpreadIsTheAdjointOfInterpolateInSpace) {
  expect_adjoint<3>();
}

template <int Dim>
void expect_forces_balance() {
  Points<Dim> inside = places<Dim>(40);
  for (auto& place : inside)
    for (int d = 1; d < Dim; ++d) place[d] = 0.2 + 0.6 * place[d];  // three cells from the walls
  const Points<Dim> forces = random_points<Dim>(40, 23);
  Tank<Dim> tank(inside);
  const petsc::Vector f = tank.grid.face_vector();
  const Point<Dim> reaction = tank.transfer.spread_with_reaction(tank.mine(forces), f);
  EXPECT_LE((tank.integral(f) - total<Dim>(forces)).norm(), 1e-12 * 40);
  EXPECT_LE(reaction.norm(), 1e-12);

  for (auto& place : inside) place[1] = 0.1 * tank.grid.spacing()[1];  // a tenth of a cell from the wall
  Tank<Dim> near(inside);
  WASH_PETSC(VecZeroEntries(f));
  const Point<Dim> held = near.transfer.spread_with_reaction(near.mine(forces), f);
  EXPECT_LE((near.integral(f) + held - total<Dim>(forces)).norm(), 1e-12 * 40);
  EXPECT_GT(held.norm(), 0.1 * total<Dim>(forces).norm());
}

TEST(Transfer, FluidForceAndWallReactionMakeUpTheElasticForceInThePlane) {
  expect_forces_balance<2>();
}
TEST(Transfer, FluidForceAndWallReactionMakeUpTheElasticForceInSpace) {
  expect_forces_balance<3>();
}

TEST(Transfer, AMarkerNearAWallMovesWithTheShear) {
  GridShape<2> shape;
  shape.cells = {16, 16};
  shape.periodic = {true, false};
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  Boundary<2>::Sides sides;
  sides[1][1].velocity = {1, 0};
  Boundary<2> boundary(grid, sides);
  const petsc::Vector velocity = grid.face_vector();
  {
    const FaceView<2> u(grid.wide_face_dm(), velocity);
    for_each<2>(grid.owned(), [&](const Index<2>& face) { u(face, 0) = grid.face_center(face, 0)[1]; });
  }
  const GhostedVelocity<2> local(boundary, grid.wide_face_dm(), velocity, 0);
  Transfer<2> transfer(grid, boundary, {});
  const double y = 0.1 / 16;
  const Points<2> place = rank_of(grid.comm()) == 0 ? Points<2>{{0.3, y}, {0.6, 0.4}} : Points<2>{};
  transfer.locate(place);
  const Points<2> u = transfer.interpolate(local);
  if (rank_of(grid.comm()) == 0) {
    EXPECT_NEAR(u[0][0], y, 0.2 * y);
    EXPECT_NEAR(u[1][0], 0.4, 1e-3);
  }
}

TEST(Transfer, MassIsKeptAtWalls) {
  Points<2> places_near_wall;
  for (int k = 0; k < 10; ++k) places_near_wall.emplace_back(0.1 * k, 0.002);
  Tank<2> tank(places_near_wall);
  const petsc::Vector density = tank.grid.face_vector();
  tank.transfer.spread_mass(std::vector<double>(tank.positions.size(), 0.5), density);
  EXPECT_NEAR(tank.integral(density)[0], 5, 1e-12);  // the x faces: none lies in the wall
}

TEST(Transfer, AMarkerOutsideTheBoxStopsTheRun) {
  Tank<2> tank(places<2>(3));
  Points<2> lost = tank.positions;
  for (auto& place : lost) place[1] = 1.5;
  EXPECT_THROW(tank.transfer.locate(lost), DivergedError);
}

template <int Dim>
std::vector<std::size_t> numbers_of(const Points<Dim>& all) {
  std::vector<std::size_t> numbers(all.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// Away from walls, with uniform density, the matrix is spread, divide by the density, interpolate.
template <int Dim>
void expect_matrix_is_spread_and_interpolate(PetscInt periodic_cells) {
  Points<Dim> all = random_points<Dim>(60, 21, 0.2);  // close together, across the periodic sides
  for (auto& place : all) {
    place += Point<Dim>::Constant(0.5);
    place[0] -= 0.5;
    if (place[0] < 0) place[0] += 1;
  }
  Tank<Dim> tank(all, periodic_cells);
  const petsc::Vector density = tank.grid.face_vector();
  WASH_PETSC(VecSet(density, 1000));
  const std::vector<double> ones(tank.positions.size(), 1.0);
  const std::vector<double> sums =
      row_sum_mobility<Dim>(tank.transfer, tank.grid, tank.boundary, density, nullptr, ones);
  MobilityMatrix<Dim> mobility(tank.grid, {});
  mobility.assemble(all, numbers_of(all), tank.numbers.front(), sums);

  const Points<Dim> forces = tank.mine(random_points<Dim>(60, 22));
  const petsc::Vector acceleration = tank.grid.face_vector();
  tank.transfer.spread(forces, acceleration);
  WASH_PETSC(VecPointwiseDivide(acceleration, acceleration, density));
  const petsc::LocalVector local(tank.grid.wide_face_dm(), acceleration);
  tank.boundary.fill_homogeneous(local);
  const Points<Dim> expected = tank.transfer.interpolate(local);

  const Points<Dim> found = mobility.times(forces);
  for (std::size_t m = 0; m < forces.size(); ++m)
    for (int d = 0; d < Dim; ++d) EXPECT_NEAR(found[m][d], expected[m][d], 1e-12 * sums[m]) << m;
}

TEST(Mobility, MatrixIsSpreadAndInterpolate) {
  for (const PetscInt periodic_cells : {15, 6}) {  // on 6, two deltas meet on both sides
    expect_matrix_is_spread_and_interpolate<2>(periodic_cells);
    expect_matrix_is_spread_and_interpolate<3>(periodic_cells);
  }
}

// Entry by entry, with walls, periodic sides and row sums that no overlap explains.
template <int Dim>
void expect_product_is_matrix(double width) {
  const Points<Dim> all = places<Dim>(60);
  Tank<Dim> tank(all, 17);
  const DeltaOptions delta{DeltaKernel::cosine, width, width};
  std::vector<double> sums;
  for (const auto& place : tank.positions) sums.push_back(1 + place[0] * place[1]);
  MobilityMatrix<Dim> matrix(tank.grid, delta);
  matrix.assemble(all, numbers_of(all), tank.numbers.front(), sums, 0.01);
  FaceMobility<Dim> faces(tank.grid, delta);
  faces.locate(tank.positions, sums, 0.01);
  const Points<Dim> forces = tank.mine(random_points<Dim>(60, 22));
  const Points<Dim> expected = matrix.times(forces), found = faces.times(forces);
  for (std::size_t m = 0; m < forces.size(); ++m) EXPECT_LE((found[m] - expected[m]).norm(), 1e-12 * sums[m]) << m;
}

TEST(Mobility, ThroughFacesIsThatOfTheMatrix) {
  for (const double width : {1.5, 2.0, 3.0}) {
    expect_product_is_matrix<2>(width);
    expect_product_is_matrix<3>(width);
  }
}

// Many markers in one place have more pairs than faces.
TEST(Mobility, GoesThroughFacesWhereMarkersAreManyInOnePlace) {
  const Tank<3> tank(places<3>(60), 17);
  const FaceMobility<3> faces(tank.grid, {}), unequal(tank.grid, {DeltaKernel::cosine, 2, 3});
  const Points<3> few = places<3>(100);
  Points<3> many = random_points<3>(3000, 1, 0.1);
  for (auto& place : many) place += Point<3>::Constant(0.5);
  const auto is_faster = [](const FaceMobility<3>& mobility, const Points<3>& all) {
    const auto rank = static_cast<std::size_t>(rank_of(PETSC_COMM_WORLD)),
               ranks = static_cast<std::size_t>(ranks_of(PETSC_COMM_WORLD));
    const std::size_t first = all.size() * rank / ranks, end = all.size() * (rank + 1) / ranks;
    return mobility.is_faster(all, first, end - first);
  };
  EXPECT_FALSE(is_faster(faces, few));
  EXPECT_TRUE(is_faster(faces, many));
  EXPECT_FALSE(is_faster(unequal, many));  // not symmetric
}

TEST(Mobility, OfALoneMarkerIsAboutThatOfTheWaterAround) {
  // one marker of length ds: m = ds sum(delta^2) h^2 / rho
  Tank<2> tank({{0.5, 0.5}});
  const petsc::Vector density = tank.grid.face_vector();
  WASH_PETSC(VecSet(density, 1000));
  const std::vector<double> lengths(tank.positions.size(), 0.05);
  for (const double m : row_sum_mobility<2>(tank.transfer, tank.grid, tank.boundary, density, nullptr, lengths)) {
    EXPECT_GT(m, 0.05 * 0.1 / (1000 * tank.grid.cell_volume()));
    EXPECT_LT(m, 0.05 * 0.2 / (1000 * tank.grid.cell_volume()));
  }
}

}  // namespace
}  // namespace washfsi::test
