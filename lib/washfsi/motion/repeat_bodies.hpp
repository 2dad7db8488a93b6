// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// Repeats bodies along the periodic axes of a grid. A body at least as long as a period must be uniform along it; then
/// it continues through the sides. An endless shape, such as a half space, that is not uniform is not repeated, and
/// must meet a body where it passes a side. Collective. Errors: InputError.
template <int Dim>
std::vector<Body<Dim>> repeat_bodies(const Grid<Dim>& grid, std::vector<Body<Dim>> bodies);

extern template std::vector<Body<2>> repeat_bodies<2>(const Grid<2>&, std::vector<Body<2>>);
extern template std::vector<Body<3>> repeat_bodies<3>(const Grid<3>&, std::vector<Body<3>>);

}  // namespace washfsi
