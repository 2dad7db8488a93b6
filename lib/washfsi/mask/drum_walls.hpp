// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// The sides of a box in which bodies move: one that fills the box up to its walls, as a turning drum does, takes them
/// along, and they get its velocity. Errors: InputError if the user gave such a wall another one.
template <int Dim>
typename Boundary<Dim>::Sides sides_with_drum(typename Boundary<Dim>::Sides sides, const GridShape<Dim>& shape,
                                              const std::vector<Body<Dim>>& bodies);

}  // namespace washfsi
