// SPDX-License-Identifier: BSD-3-Clause
//
// The library without the program: vortices that decay by viscosity, u = -cos kx sin ky, v = sin kx cos ky, whose
// energy falls as exp(-4 nu k^2 t). Prints the energy over the exact one.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/fluid/fractional_step.hpp"
#include "washfsi/support/program.hpp"

namespace {

using namespace washfsi;

void decay() {
  GridShape<2> shape;
  shape.cells = {64, 64};
  shape.periodic = {true, true};
  Boundary<2>::Sides sides;
  for (auto& axis : sides)
    for (auto& side : axis) side.kind = BoundaryKind::periodic;
  const Grid<2> grid(PETSC_COMM_WORLD, shape);
  Boundary<2> boundary(grid, sides);

  FluidOptions<2> options;
  options.density = 1;
  options.viscosity = 0.01;
  const Liquid<2> liquid(grid, boundary, {options.density, options.viscosity});
  FractionalStep<2> fluid(grid, boundary, options);
  constexpr double k = 2 * std::numbers::pi;
  fluid.start([](const Point<2>& x, int c) {
    return c == 0 ? -std::cos(k * x[0]) * std::sin(k * x[1]) : std::sin(k * x[0]) * std::cos(k * x[1]);
  });

  const petsc::Vector no_force = grid.face_vector();
  Clock clock;
  constexpr double dt = 2e-3;
  while (clock.step < 250) {
    fluid.predict(clock.next(dt), {liquid.fields(), no_force, {}});
    fluid.projection().project();
    fluid.finish();
    clock.advance(dt);
  }
  const GhostedVelocity<2> velocity(boundary, grid.face_dm(), fluid.velocity(), clock.time);
  const double energy = FlowDiagnostics<2>::of(grid, {velocity, liquid.fields()}, dt).kinetic_energy;
  const double exact = 0.25 * std::exp(-4 * options.viscosity * k * k * clock.time);
  if (rank_of(grid.comm()) == 0) std::printf("t = %g s: energy over the exact one %.4f\n", clock.time, energy / exact);
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("taylor_green", [&] {
    WASH_PETSC(PetscInitialize(&argc, &argv, nullptr, nullptr));
    decay();
  });
}
