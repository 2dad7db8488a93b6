// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// Makes bodies repeat themselves along the periodic axes of a grid. One that is as long as a period or longer must be
/// the same all along it; then it goes on through the sides. A shape without end, such as a half space, that is not so
/// stays as it lies, and must meet a body where it passes a side. Collective. Errors: InputError.
template <int Dim>
std::vector<Body<Dim>> repeat_bodies(const Grid<Dim>& grid, std::vector<Body<Dim>> bodies);

extern template std::vector<Body<2>> repeat_bodies<2>(const Grid<2>&, std::vector<Body<2>>);
extern template std::vector<Body<3>> repeat_bodies<3>(const Grid<3>&, std::vector<Body<3>>);

}  // namespace washfsi
