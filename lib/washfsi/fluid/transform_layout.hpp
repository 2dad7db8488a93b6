// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/grid/index.hpp"

namespace washfsi {

/// The distribution of a box's cells while some of its axes are transformed: the box is cut into parts as equal as
/// possible, of which rank r has number r, counted along x first; a rank's cells lie in memory along `order[0]` first.
template <int Dim>
struct TransformLayout {
  Index<Dim> cells;            ///< cells of the whole box
  std::array<int, Dim> parts;  ///< number of parts along each axis
  std::array<int, Dim> order;  ///< axes, the one contiguous in memory first
  int transformed;             ///< number of leading axes of `order` that are transformed and not cut

  /// The cells of a rank; an empty box beyond the last part.
  Box<Dim> owned_by(int rank) const;
  int owner(const Index<Dim>& cell) const;
  /// Place of a cell among those of its owner, and the cell of a place among those of a box.
  PetscInt offset(const Box<Dim>& box, const Index<Dim>& cell) const;
  Index<Dim> cell(const Box<Dim>& box, PetscInt offset) const;
};

template <int Dim>
using TransformLayouts = std::vector<TransformLayout<Dim>>;

/// A sequence of layouts in which each axis is transformed once: slabs, cut along the last axis, with all other axes
/// transformed, and columns, cut along the last but one; in space, on more ranks than these have layers, pencils.
template <int Dim>
TransformLayouts<Dim> transform_layouts(const Index<Dim>& cells, int ranks);

/// Pencils: three layouts cut along two axes each, with the third transformed.
TransformLayouts<3> pencil_layouts(const Index<3>& cells, int ranks);

extern template struct TransformLayout<2>;
extern template struct TransformLayout<3>;

}  // namespace washfsi
