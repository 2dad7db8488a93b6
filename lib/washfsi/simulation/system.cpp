// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/simulation/system.hpp"

#include <algorithm>
#include <cmath>

#include "washfsi/support/errors.hpp"

namespace washfsi {

namespace {

// Ghost layers that hold the stencil of a marker anywhere in an owned cell.
template <int Dim>
GridShape<Dim> with_ghosts_for(GridShape<Dim> shape, const DeltaOptions& delta) {
  shape.ghost_width = static_cast<PetscInt>(std::ceil(std::max(delta.spread_width, delta.interpolate_width))) + 1;
  return shape;
}

}  // namespace

template <int Dim>
SystemOptions<Dim> SystemOptions<Dim>::from_options(Options& options) {
  SystemOptions<Dim> system;
  system.grid = GridOptions<Dim>::from_options(options);
  system.fluid = FluidOptions<Dim>::from_options(options);
  options.block("", "Gravity", [&](OptionBlock& block) {
    block.template point<Dim>("gravity", system.gravity, "m/s2", "acceleration by gravity, acting on excess mass");
  });
  system.cloths = cloth_groups_from_options(options);
  if (Dim == 3 && !system.cloths.empty() && !options.help())
    throw InputError("-cloths " + system.cloths.front().name +
                     ": cloth needs a grid of two dimensions (nx,ny in -grid_cells)");
  for (const ClothGroup& group : system.cloths)
    system.placements.push_back(PlacementOptions<Dim>::from_options(options, group.name));
  system.delta = DeltaOptions::from_options(options);
  system.contact = ContactOptions::from_options(options);
  return system;
}

template <int Dim>
System<Dim>::System(MPI_Comm comm, const SystemOptions<Dim>& options, std::vector<Body<Dim>> rigid_bodies)
    : grid(comm, with_ghosts_for(options.grid.shape, options.delta)),
      boundary(grid, options.grid.sides),
      bodies(std::move(rigid_bodies)),
      mask(grid, bodies),
      fluid(grid, boundary, options.fluid),
      cloths(comm, options.cloths),
      transfer(grid, boundary, options.delta),
      fluid_density(options.fluid.density),
      contact(options.contact),
      gravity(options.gravity),
      density(grid.face_vector()),
      force(grid.face_vector()) {
  WASH_PETSC(VecSet(density, fluid_density));
  const Points<Dim> all = place_cloths<Dim>(cloths, options.placements, bodies, grid.lower(), grid.upper());
  positions.assign(all.begin() + cloths.begin(), all.begin() + cloths.end());
  velocities.assign(positions.size(), Point<Dim>::Zero());
  contact_loads.resize(bodies.size());
  locate_cloth();
}

template <int Dim>
void System<Dim>::locate_cloth() {
  transfer.locate(positions);
  if (cloths.marker_count() == 0) return;
  WASH_PETSC(VecSet(density, fluid_density));
  transfer.spread_mass(cloths.marker_masses(), density);
}

template struct SystemOptions<2>;
template struct SystemOptions<3>;
template struct System<2>;
template struct System<3>;

}  // namespace washfsi
