// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/shapes/shape.hpp"

namespace washfsi {

/// The direction in which one leaves a thin part of a shape soonest on both sides, from a place within it. `cell` is
/// the grid's spacing [m]: thin is what is thinner than 3/2 cells in that direction, as wide or narrow as they may be
/// in it.
template <int Dim>
Point<Dim> sheet_normal(const Shape<Dim>& shape, const Point<Dim>& place, const Point<Dim>& cell);

extern template Point<2> sheet_normal<2>(const Shape<2>&, const Point<2>&, const Point<2>&);
extern template Point<3> sheet_normal<3>(const Shape<3>&, const Point<3>&, const Point<3>&);

}  // namespace washfsi
