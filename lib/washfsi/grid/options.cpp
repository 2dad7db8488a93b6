// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/grid/options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "washfsi/support/errors.hpp"

namespace washfsi {

const ChoiceNames<BoundaryKind>& names_of(BoundaryKind) {
  static const ChoiceNames<BoundaryKind> names{{"wall", BoundaryKind::wall},
                                               {"slip", BoundaryKind::slip},
                                               {"inflow", BoundaryKind::inflow},
                                               {"outflow", BoundaryKind::outflow},
                                               {"periodic", BoundaryKind::periodic}};
  return names;
}

const ChoiceNames<InflowProfile>& names_of(InflowProfile) {
  static const ChoiceNames<InflowProfile> names{{"uniform", InflowProfile::uniform},
                                                {"parabolic", InflowProfile::parabolic}};
  return names;
}

namespace {

std::vector<double> read_cells(OptionBlock& block) {
  std::vector<double> cells{64, 64};
  block.require("grid_cells", "the number of cells in each direction, nx,ny or nx,ny,nz");
  block.reals("grid_cells", cells, 2, 3, "-", "cells in x,y[,z]; the number of values is the dimension");
  for (const double n : cells)
    if (n < 1 || n > 1e5 || n != std::floor(n))
      throw InputError("-grid_cells " + to_text(n) + ": must be whole numbers from 1 to 100000");
  return cells;
}

template <int Dim>
Side<Dim> read_side(OptionBlock& block, const std::string& name, int axis, End end) {
  Side<Dim> side;
  block.choice(name, side.kind, "what holds on this side of the box");
  block.template point<Dim>(name + "_velocity", side.velocity, "m/s", "velocity of the wall or inflow on this side");
  block.choice(name + "_profile", side.profile,
               "of an inflow; parabolic: 0 at the walls beside it, the velocity given is its peak");
  const bool free = side.kind == BoundaryKind::periodic || side.kind == BoundaryKind::outflow;
  if (free && side.velocity != Point<Dim>::Zero())
    throw InputError("-" + name + "_velocity " + list_text<Dim>(side.velocity) + ": the side is " + name_of(side.kind) +
                     " and takes no velocity");
  Point<Dim> along = side.velocity;
  along[axis] = 0;
  if (side.kind == BoundaryKind::slip && along != Point<Dim>::Zero())
    throw InputError("-" + name + "_velocity " + list_text<Dim>(side.velocity) +
                     ": the side is slip, along which water moves freely; give wall, or a velocity across it");
  if (side.kind != BoundaryKind::inflow && side.profile != InflowProfile::uniform)
    throw InputError("-" + name + "_profile " + name_of(side.profile) +
                     ": only for a side that is inflow, this one is " + name_of(side.kind));
  const double inward = end == End::lower ? side.velocity[axis] : -side.velocity[axis];
  if (side.kind == BoundaryKind::inflow && inward < 0)
    throw InputError("-" + name + "_velocity " + list_text<Dim>(side.velocity) +
                     ": points out of the box; an inflow must point into it or along its side");
  return side;
}

}  // namespace

int dimension_from_options(Options& options) {
  std::size_t dimension = 2;
  options.block("", "Grid", [&](OptionBlock& block) { dimension = read_cells(block).size(); });
  return static_cast<int>(dimension);
}

template <int Dim>
GridOptions<Dim> GridOptions<Dim>::from_options(Options& options, const Refinement& refinement) {
  GridOptions<Dim> grid;
  options.block("", "Grid and boundary", [&](OptionBlock& block) {
    std::vector<double> cells = read_cells(block);
    refinement.multiply(options, "grid_cells", cells);
    for (int d = 0; d < Dim; ++d) grid.shape.cells[d] = static_cast<PetscInt>(cells[d]);
    block.template point<Dim>("grid_lower", grid.shape.lower, "m", "lower corner of the box");
    block.template point<Dim>("grid_upper", grid.shape.upper, "m", "upper corner of the box");
    for (int d = 0; d < Dim; ++d) {
      const std::string name = std::string("bc_") + "xyz"[d];
      grid.sides[d] = {read_side<Dim>(block, name + "_lower", d, End::lower),
                       read_side<Dim>(block, name + "_upper", d, End::upper)};
      const bool lower = grid.sides[d][0].kind == BoundaryKind::periodic;
      if (lower != (grid.sides[d][1].kind == BoundaryKind::periodic))
        throw InputError("-" + name + "_lower, -" + name + "_upper: both sides must be periodic, or neither");
      grid.shape.periodic[d] = lower;
    }
  });
  return grid;
}

template struct GridOptions<2>;
template struct GridOptions<3>;

}  // namespace washfsi
