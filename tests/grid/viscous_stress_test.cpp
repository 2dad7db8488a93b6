// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/viscous_stress.hpp"

#include <random>

#include <gtest/gtest.h>

#include "washfsi/support/collective.hpp"

namespace washfsi::test {
namespace {

// Numbers of a cell or face that do not depend on how the grid is shared among ranks.
template <int Dim>
double noise(const Index<Dim>& index, int c, unsigned seed) {
  unsigned word = seed + 7919U * static_cast<unsigned>(c);
  for (const PetscInt i : index) word = 1664525U * word + 1013904223U + static_cast<unsigned>(i);
  std::minstd_rand random(word);
  random.discard(3);
  return 2 * static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max()) - 1;
}

// A box with a wall, a slip side and, along the last axis, periodic sides.
template <int Dim>
class ViscousStress {
 public:
  ViscousStress() : grid(PETSC_COMM_WORLD, shape()), boundary(grid, sides()), mu(grid.cell_vector()) {
    const CellView<Dim> view(grid.cell_dm(), mu);
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) { view(cell) = std::pow(10, noise<Dim>(cell, 0, 1)); });
  }

  static GridShape<Dim> shape() {
    GridShape<Dim> shape;
    for (std::size_t d = 0; d < Dim; ++d) shape.cells[d] = 9 + 2 * static_cast<PetscInt>(d);
    shape.upper[1] = 1.7;
    shape.periodic[Dim - 1] = true;
    return shape;
  }
  static typename Boundary<Dim>::Sides sides() {
    typename Boundary<Dim>::Sides sides;
    sides[0][1].kind = BoundaryKind::slip;
    for (auto& side : sides[Dim - 1]) side.kind = BoundaryKind::periodic;
    return sides;
  }

  // Random on unknown faces, zero on those in the box's sides.
  petsc::Vector random_velocity(unsigned seed) const {
    petsc::Vector velocity = grid.face_vector();
    const FaceView<Dim> u(grid.face_dm(), velocity);
    grid.for_each_inner_face([&](const Index<Dim>& face, auto c) { u(face, c) = noise<Dim>(face, c, seed); });
    return velocity;
  }

  ViscosityField<Dim> viscosity() const {
    ViscosityField<Dim> field(grid);
    WASH_PETSC(DMGlobalToLocal(grid.cell_dm(), mu, INSERT_VALUES, field.in_cells()));
    boundary.fill_cells(field.in_cells());
    field.find_edges();
    return field;
  }

  // v . div tau(u)
  double work(Vec u_global, Vec v_global) const {
    const petsc::LocalVector local(grid.face_dm(), u_global);
    boundary.fill_homogeneous(local);
    const ConstFaceView<Dim> u(grid.face_dm(), local), v(grid.face_dm(), v_global);
    const ViscosityField<Dim> field = viscosity();
    double sum = 0;
    with_viscosity<Dim>(grid, field.viscosity(), [&](const auto& form) {
      grid.for_each_inner_face(
          [&](const Index<Dim>& face, auto c) { sum += form.scale * v(face, c) * form.force(u, face, c); });
    });
    return ordered_sum(grid.comm(), sum);
  }

  // 2 mu e : e, summed over cells and edges, an edge in a wall having half a cell; nothing else may be dissipated.
  double dissipation(Vec u_global) const {
    const petsc::LocalVector local(grid.face_dm(), u_global), cells(grid.cell_dm(), mu);
    boundary.fill_homogeneous(local);
    boundary.fill_cells(cells);
    const ConstFaceView<Dim> u(grid.face_dm(), local);
    const ConstCellView<Dim> m(grid.cell_dm(), cells);
    const Point<Dim> h = grid.spacing();
    double sum = 0;
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
      for (int c = 0; c < Dim; ++c) {
        const double strain = (u(shifted<Dim>(cell, c, 1), c) - u(cell, c)) / h[c];
        sum += 2 * m(cell) * strain * strain;
        for (int d = 0; d < c; ++d)
          for (int upper_c = 0; upper_c < 2; ++upper_c)
            for (int upper_d = 0; upper_d < 2; ++upper_d) {  // a quarter of each edge belongs to the cell
              const Index<Dim> edge = shifted<Dim>(shifted<Dim>(cell, c, upper_c), d, upper_d);
              const Index<Dim> below = shifted<Dim>(edge, d, -1), left = shifted<Dim>(edge, c, -1);
              const double shear = (u(edge, c) - u(below, c)) / h[d] + (u(edge, d) - u(left, d)) / h[c];
              const double mean = 0.25 * (m(edge) + m(below) + m(left) + m(shifted<Dim>(left, d, -1)));
              sum += 0.25 * mean * shear * shear;
            }
      }
    });
    return ordered_sum(grid.comm(), sum);
  }

  Grid<Dim> grid;
  Boundary<Dim> boundary;
  petsc::Vector mu;
};

template <int Dim>
void expect_symmetric_and_dissipative() {
  const ViscousStress<Dim> stress;
  for (unsigned n = 0; n < 10; ++n) {
    const petsc::Vector u = stress.random_velocity(10 + n), v = stress.random_velocity(100 + n);
    const double work = stress.work(u, u);
    EXPECT_NEAR(stress.work(u, v), stress.work(v, u), 1e-12 * std::abs(work));
    EXPECT_LT(work, 0);
    EXPECT_NEAR(-work, stress.dissipation(u), 1e-12 * std::abs(work));
  }
}

TEST(ViscousStress, IsSymmetricAndTakesOutWhatItDissipatesInThePlane) {
  expect_symmetric_and_dissipative<2>();
}
TEST(ViscousStress, IsSymmetricAndTakesOutWhatItDissipatesInSpace) {
  expect_symmetric_and_dissipative<3>();
}

// The force of a uniform viscosity given cell by cell is mu lap u where div u = 0.
TEST(ViscousStress, OfAnEvenViscosityIsTheLaplacianOfADivergenceFreeFlow) {
  GridShape<2> shape;
  shape.cells = {12, 16};
  shape.periodic = {true, true};
  Boundary<2>::Sides sides;
  for (auto& axis : sides)
    for (auto& side : axis) side.kind = BoundaryKind::periodic;
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  const Boundary<2> boundary(grid, sides);
  const petsc::Vector velocity = grid.face_vector();
  {
    const FaceView<2> u(grid.face_dm(), velocity);
    const auto stream = [](PetscInt i, PetscInt j) { return noise<2>({(i + 12) % 12, (j + 16) % 16}, 0, 5); };
    for_each<2>(grid.owned(), [&](const Index<2>& cell) {
      u(cell, 0) = (stream(cell[0], cell[1] + 1) - stream(cell[0], cell[1])) / grid.spacing()[1];
      u(cell, 1) = -(stream(cell[0] + 1, cell[1]) - stream(cell[0], cell[1])) / grid.spacing()[0];
    });
  }
  const petsc::LocalVector local(grid.face_dm(), velocity);
  ViscosityField<2> mu(grid);
  WASH_PETSC(VecSet(mu.in_cells(), 0.3));
  mu.find_edges();
  const ConstFaceView<2> u(grid.face_dm(), local);
  const CellViscosity<2> uneven(grid, mu.viscosity());
  const UniformViscosity<2> even(grid, 0.3);
  grid.for_each_inner_face([&](const Index<2>& face, auto c) {
    EXPECT_NEAR(uneven.force(u, face, c), even.scale * even.force(u, face, c), 1e-11 * 16 * 16 * 16);
  });
}

template <int Dim>
void expect_mirrored_beyond_sides() {
  const ViscousStress<Dim> stress;
  const Grid<Dim>& grid = stress.grid;
  const petsc::LocalVector local(grid.cell_dm(), stress.mu);
  stress.boundary.fill_cells(local);
  const ConstCellView<Dim> mu(grid.cell_dm(), local);
  Box<Dim> with_ghosts = grid.owned();
  for (std::size_t d = 0; d < Dim; ++d) --with_ghosts.lower[d], ++with_ghosts.upper[d];
  for_each<Dim>(with_ghosts, [&](const Index<Dim>& cell) {
    Index<Dim> inside = cell;
    for (std::size_t d = 0; d < Dim; ++d) {
      const PetscInt n = grid.cells()[d];
      if (d == Dim - 1)
        inside[d] = (cell[d] + n) % n;
      else if (cell[d] < 0 || cell[d] >= n)
        inside[d] = cell[d] < 0 ? -1 - cell[d] : 2 * n - 1 - cell[d];
    }
    EXPECT_EQ(mu(cell), std::pow(10, noise<Dim>(inside, 0, 1)));
  });
}

TEST(CellField, IsMirroredBeyondTheSides) {
  expect_mirrored_beyond_sides<2>();
  expect_mirrored_beyond_sides<3>();
}

}  // namespace
}  // namespace washfsi::test
