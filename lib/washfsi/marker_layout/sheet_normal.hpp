// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// The direction in which a thin part of a shape is thinnest, from a place within it. `cell` is the grid's spacing [m]:
/// thin parts are thinner than 3/2 cells, measured in that direction.
template <int Dim>
Point<Dim> sheet_normal(const Shape<Dim>& shape, const Point<Dim>& place, const Point<Dim>& cell);

extern template Point<2> sheet_normal<2>(const Shape<2>&, const Point<2>&, const Point<2>&);
extern template Point<3> sheet_normal<3>(const Shape<3>&, const Point<3>&, const Point<3>&);

}  // namespace washfsi
