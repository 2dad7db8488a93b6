// SPDX-License-Identifier: BSD-3-Clause
//
// A liquid whose density differs from face to face: its weight is balanced by a pressure, and nothing moves.
#include <cmath>

#include <gtest/gtest.h>

#include "support/water.hpp"
#include "washfsi/support/vector_range.hpp"

namespace washfsi::test {
namespace {

constexpr double gravity = 9.81, light = 1000;

// The density at a height above the middle of the box [m], from 1000 to 3000 kg/m3 downwards.
double density_at(double height) {
  return light * (2 - std::tanh(height / 0.1));
}

/// The weight of a liquid less that of the pure one: (rho - rho_pure) g downwards along the last axis.
template <int Dim>
class Weight : public ForceField {
 public:
  Weight(const Grid<Dim>& grid, const Liquid<Dim>& liquid) : grid_(grid), liquid_(liquid) {}
  void add_to(Vec force) const override {
    const ConstFaceView<Dim> rho(grid_.face_dm(), liquid_.own_density());
    const FaceView<Dim> f(grid_.face_dm(), force);
    for_each<Dim>(grid_.owned(), [&](const Index<Dim>& face) {
      f(face, Dim - 1) -= gravity * (rho(face, Dim - 1) - liquid_.pure().density);
    });
  }

 private:
  const Grid<Dim>& grid_;
  const Liquid<Dim>& liquid_;
};

/// A closed box of a metre, stratified or turned upside down.
template <int Dim>
struct StratifiedBox {
  explicit StratifiedBox(double upwards) {
    const petsc::Vector density = grid.face_vector();
    {
      const FaceView<Dim> rho(grid.face_dm(), density);
      for_each<Dim>(grid.owned(), [&](const Index<Dim>& face) {
        for (int c = 0; c < Dim; ++c) rho(face, c) = density_at(upwards * (grid.face_center(face, c)[Dim - 1] - 0.5));
      });
    }
    water.liquid.set_own_density(density);
    balance(upwards);
  }
  // The pressure whose difference over each face is the weight there; its mean does not matter.
  void balance(double upwards) {
    const CellView<Dim> p(grid.cell_dm(), water.fluid.projection().pressure());
    for_each<Dim>(grid.owned(), [&](const Index<Dim>& cell) {
      double sum = 0;
      for (Index<Dim> face = cell; face[Dim - 1] > 0; --face[Dim - 1])
        sum += density_at(upwards * (grid.face_center(face, Dim - 1)[Dim - 1] - 0.5)) - light;
      p(cell) = -gravity * grid.spacing()[Dim - 1] * sum;
    });
  }
  static GridShape<Dim> shape() {
    GridShape<Dim> shape;
    shape.cells.fill(Dim == 2 ? 32 : 12);
    return shape;
  }
  static FluidOptions<Dim> options() {
    FluidOptions<Dim> options;
    options.density = light;
    options.viscosity = 1;
    return options;
  }
  // The largest speed after some steps over sqrt(g L).
  double speed_after(int steps) {
    const Weight<Dim> weight(grid, water.liquid);
    for (int n = 0; n < steps; ++n)
      water.take_step(
          1e-3, {.liquid = water.liquid.fields(), .force = water.force, .constraint = {}, .force_fields = {&weight}});
    double speed = 0;
    WASH_PETSC(VecNorm(water.fluid.velocity(), NORM_INFINITY, &speed));
    return speed / std::sqrt(gravity);
  }

  Grid<Dim> grid{PETSC_COMM_WORLD, shape()};
  Boundary<Dim> boundary{grid, {}};
  Water<Dim> water{grid, boundary, options()};
};

template <int Dim>
void expect_rest(double upwards) {
  StratifiedBox<Dim> box(upwards);
  EXPECT_LT(box.speed_after(20), 1e-10);
  const VectorRange pressures = range_of(box.water.fluid.projection().pressure());
  // from the middle of the lowest cell to that of the highest: heavy and light halves balance but for the ends
  EXPECT_NEAR((pressures.most - pressures.least) / (light * gravity * (1 - box.grid.spacing()[Dim - 1])), 1, 1e-3);
}

TEST(StratifiedLiquid, StaysAtRestInThePlane) {
  expect_rest<2>(1);
}
TEST(StratifiedLiquid, StaysAtRestInSpace) {
  expect_rest<3>(1);
}
// No disturbance is there to grow: what is heavy stays above.
TEST(StratifiedLiquid, StaysAtRestUpsideDown) {
  expect_rest<2>(-1);
}

TEST(StratifiedLiquid, MovesByAForceThatNoPressureBalances) {
  StratifiedBox<2> box(1);
  {
    const FaceView<2> f(box.grid.face_dm(), box.water.force);
    for_each<2>(box.grid.owned(), [&](const Index<2>& face) { f(face, 1) = box.grid.face_center(face, 1)[0]; });
  }
  EXPECT_GT(box.speed_after(1), 1e-8);
}

}  // namespace
}  // namespace washfsi::test
