// SPDX-License-Identifier: BSD-3-Clause
//
// Cloths for the tests of the barrier.
#pragma once

#include <gtest/gtest.h>

#include "support/random_points.hpp"
#include "washfsi/contact/barrier.hpp"
#include "washfsi/support/of_all_ranks.hpp"

namespace washfsi::test {

constexpr double spacing = 0.02, distance = 0.005;

template <int Dim>
ClothGroup<Dim> towel() {
  ClothGroup<Dim> group;
  group.name = "towel";
  group.count = 3;
  group.markers = {6, Dim == 3 ? 5 : 1};
  group.sheet.width = Dim == 3 ? 5 : 1;
  group.sheet.ds = spacing;
  group.sheet.dr = Dim == 3 ? spacing : 1;
  return group;
}

/// Three cloths that lie one on another, uneven, in a large box, on some ranks.
template <int Dim>
struct Stack {
  explicit Stack(double gap = 0.6 * distance, bool is_periodic = false, MPI_Comm of_ranks = PETSC_COMM_WORLD)
      : comm(of_ranks) {
    GridShape<Dim> shape;
    shape.cells.fill(12);
    shape.lower = Point<Dim>::Constant(-0.5);
    shape.upper = Point<Dim>::Constant(0.5);
    if (is_periodic) shape.periodic.fill(true);
    grid = std::make_unique<Grid<Dim>>(comm, shape);
    boundary = std::make_unique<Boundary<Dim>>(*grid, typename Boundary<Dim>::Sides{});
    cloths = std::make_unique<Cloths<Dim>>(comm, std::vector<ClothGroup<Dim>>{towel<Dim>()});
    const auto count = static_cast<std::size_t>(cloths->marker_count());
    const Points<Dim> rough = random_points<Dim>(count, 11, 0.09 * distance);
    for (std::size_t n = 0; n < count; ++n) {
      const std::size_t width = cloths->groups()[0].sheet.width, in_cloth = n % (6 * width), cloth = n / (6 * width);
      Point<Dim> place = Point<Dim>::Zero();
      place[0] = spacing * static_cast<double>(in_cloth / width) + 0.3 * spacing * static_cast<double>(cloth);
      if constexpr (Dim == 3) place[1] = spacing * static_cast<double>(in_cloth % width) + 0.004 * place[0];
      place[Dim - 1] = gap * static_cast<double>(cloth);
      all.push_back(place + rough[n]);
    }
  }
  Points<Dim> own(const Points<Dim>& values) const {
    return {values.begin() + cloths->begin(), values.begin() + cloths->end()};
  }
  std::unique_ptr<Barrier<Dim>> barrier(const Points<Dim>& places, double friction = 0, double damping = 0) const {
    auto result = std::make_unique<Barrier<Dim>>(BarrierOptions{distance, 0, 1e4, friction, 0, damping},
                                                 Surroundings<Dim>{*grid, *boundary, bodies, *cloths});
    const Points<Dim> start = own(places), at_rest(start.size(), Point<Dim>::Zero());
    start_apart(*result);
    result->begin_step({start, at_rest, 0, 1e-3});
    return result;
  }
  /// What starts in contact would have a distance of its own.
  void start_apart(Barrier<Dim>& barrier) const {
    Points<Dim> apart = own(all);
    for (std::size_t m = 0; m < apart.size(); ++m)
      apart[m][Dim - 1] += 2 * distance * static_cast<double>(cloths->piece_of_marker()[m]);
    const Points<Dim> at_rest(apart.size(), Point<Dim>::Zero());
    barrier.begin_step({apart, at_rest, 0, 0});
  }
  Points<Dim> forces(const Barrier<Dim>& barrier, const Points<Dim>& places) const {
    Points<Dim> result(cloths->owned(), Point<Dim>::Zero());
    barrier.add_force(own(places), {}, result);
    return of_all_ranks(comm, result);
  }
  Eigen::MatrixXd stiffness(const Barrier<Dim>& barrier, GeometricStiffness geometric) const {
    const auto size = static_cast<Eigen::Index>(all.size() * Dim);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    barrier.visit_stiffness(own(all), geometric, [&](PetscInt row, PetscInt column, const StiffnessBlock<Dim>& block) {
      matrix.block<Dim, Dim>(row * Dim, column * Dim) += block;
    });
    MPI_Allreduce(MPI_IN_PLACE, matrix.data(), static_cast<int>(matrix.size()), MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
    return matrix;
  }
  double energy(const Barrier<Dim>& barrier, const Points<Dim>& places) const {
    std::vector<double> result(1, 0.0);
    barrier.add_energy(own(places), result);
    return ordered_sum(comm, result[0]);
  }
  /// Those of friction too, in an explicit step in which the cloths slide over each other.
  Points<Dim> explicit_forces() const {
    Barrier<Dim> barrier({distance, 0, 1e4, 0.4}, {*grid, *boundary, bodies, *cloths});
    const Points<Dim> start = own(all);
    Points<Dim> velocities(start.size(), Point<Dim>::Zero());
    for (std::size_t m = 0; m < velocities.size(); ++m)
      velocities[m][0] = 0.01 * static_cast<double>(cloths->piece_of_marker()[m]);
    const ExplicitStep lagged{1e-4, std::vector<double>(start.size(), 1e3)};
    start_apart(barrier);
    barrier.begin_step({start, velocities, 0, 0, {}, lagged});
    return forces(barrier, all);
  }

  MPI_Comm comm;
  std::unique_ptr<Grid<Dim>> grid;
  std::unique_ptr<Boundary<Dim>> boundary;
  std::vector<Body<Dim>> bodies;
  std::unique_ptr<Cloths<Dim>> cloths;
  Points<Dim> all;
};

template <int N>
struct Dimension {
  static constexpr int value = N;
};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;

}  // namespace washfsi::test
