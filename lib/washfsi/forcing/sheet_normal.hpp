// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/body/shape.hpp"

namespace washfsi {

/// The direction in which one leaves a thin part of a shape soonest on both sides, from a place near its middle;
/// `step` [m] is more than half its thickness.
template <int Dim>
Point<Dim> sheet_normal(const Shape<Dim>& shape, const Point<Dim>& place, double step);

extern template Point<2> sheet_normal<2>(const Shape<2>&, const Point<2>&, double);
extern template Point<3> sheet_normal<3>(const Shape<3>&, const Point<3>&, double);

}  // namespace washfsi
