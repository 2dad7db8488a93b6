// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/fluid/diagnostics.hpp"
#include "washfsi/fluid/fractional_step.hpp"

namespace washfsi::test {

/// A liquid that flows by itself: its solver with a clock, its fields and a force density, at first zero.
template <int Dim>
struct Water {
  Water(const Grid<Dim>& of_grid, Boundary<Dim>& of_boundary, const FluidOptions<Dim>& options = {})
      : grid(of_grid),
        boundary(of_boundary),
        liquid(grid, boundary, {options.density, options.viscosity}, options.viscosity_models, options.wall_model),
        fluid(grid, boundary, options),
        force(grid.face_vector()) {}

  void advance(double dt, const Constraint<Dim>& constraint = {}) {
    liquid.update_viscosity({fluid.velocity(), clock.time, nullptr, fluid.last_step()});
    take_step(dt, {liquid.fields(), force, constraint});
  }
  /// Takes a step with these fields.
  void take_step(double dt, const StepFields<Dim>& fields) {
    fluid.predict(clock.next(dt), fields);
    fluid.projection().project();
    fluid.finish();
    clock.advance(dt);
  }
  /// The velocity now, its ghosts filled.
  GhostedVelocity<Dim> ghosted(DM dm) const { return {boundary, dm, fluid.velocity(), clock.time}; }

  const Grid<Dim>& grid;
  Boundary<Dim>& boundary;
  Liquid<Dim> liquid;
  FractionalStep<Dim> fluid;
  petsc::Vector force;
  Clock clock;
};

}  // namespace washfsi::test
