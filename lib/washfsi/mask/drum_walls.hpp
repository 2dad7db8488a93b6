// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/boundary.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// Returns the sides of a box in which bodies move: a body that fills the box up to its sides, as a turning drum does,
/// gives them its velocity. Errors: InputError if the user gave such a side another velocity.
template <int Dim>
typename Boundary<Dim>::Sides sides_with_drum(typename Boundary<Dim>::Sides sides, const GridShape<Dim>& shape,
                                              const std::vector<Body<Dim>>& bodies);

}  // namespace washfsi
