// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/support/refinement.hpp"

namespace washfsi {

const ChoiceNames<BoundaryKind>& names_of(BoundaryKind);
const ChoiceNames<InflowProfile>& names_of(InflowProfile);

/// The number of dimensions, from the number of values in -grid_cells. Errors: InputError.
int dimension_from_options(Options& options);

/// -grid_cells, as often as the refinement says, -grid_lower, -grid_upper and the sides' kinds and velocities
/// (-bc_x_lower ...).
template <int Dim>
struct GridOptions {
  GridShape<Dim> shape;
  typename Boundary<Dim>::Sides sides;

  static GridOptions from_options(Options& options, const Refinement& refinement);
};

extern template struct GridOptions<2>;
extern template struct GridOptions<3>;

}  // namespace washfsi
