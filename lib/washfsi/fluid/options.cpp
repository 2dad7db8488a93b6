// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/fluid/options.hpp"

#include "washfsi/fluid/advection_scheme.hpp"
#include "washfsi/fluid/viscosity_models.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

constexpr const char* no_surface =
    "there is no surface of the water: it fills the box, but for the bodies; foam, spinning and half-filled drums are "
    "not computed";

}  // namespace

template <int Dim>
FluidOptions<Dim> FluidOptions<Dim>::from_options(Options& options) {
  FluidOptions<Dim> fluid;
  constexpr Range tolerance{1e-15, 1e-2, false, "a number from 1e-15 to 0.01"};
  options.block("", "Fluid", [&](OptionBlock& block) {
    block.real("fluid_density", fluid.density, "kg/m3", positive, "density of the water");
    block.real("fluid_viscosity", fluid.viscosity, "Pa s", non_negative,
               "dynamic viscosity of the water; 0: inviscid, not with -wall_model");
    block.boolean("fluid_projection", fluid.projection, "make the velocity divergence free");
    block.choice("advection", fluid.advection, advection_schemes(),
                 "scheme of the advection term; wide_central has less error on a given grid; upwind is bounded (van "
                 "Leer), for grids too coarse for central");
    block.integer(
        "advection_steps", fluid.advection_steps, {2, 3, false, "2 or 3"},
        "steps from which advection is extrapolated: 2, Adams-Bashforth (thesis), lets short waves grow; 3 lets "
        "them decay, up to a CFL number of 0.79");
    block.real("momentum_tolerance", fluid.momentum_tolerance, "-", tolerance,
               "rms residual of the momentum solve over the largest speed");
    block.real("pressure_tolerance", fluid.pressure_tolerance, "-", tolerance,
               "divergence left after a step over (largest speed)/h");
  });
  fluid.driving = DrivingOptions<Dim>::from_options(options);
  fluid.viscosity_models = viscosity_models_from_options<Dim>(options);
  options.block("", "Walls", [&](OptionBlock& block) {
    block.choice("wall_model", fluid.wall_model,
                 "friction of no-slip sides of the box, and of bodies with -body_method direct_forcing; equilibrium: "
                 "by the law of a "
                 "turbulent wall layer, for layers thinner than a cell");
  });
  if (fluid.wall_model != WallTreatment::none && fluid.viscosity == 0)
    throw InputError("-wall_model " + name_of(fluid.wall_model) + ": needs a -fluid_viscosity > 0");
  if (!fluid.projection) options.mark_idle("-fluid_projection is false", {"pressure_tolerance"});
  options.answer("water_level", no_surface);
  options.answer("water_shape", no_surface);
  return fluid;
}

template struct FluidOptions<2>;
template struct FluidOptions<3>;

}  // namespace washfsi
