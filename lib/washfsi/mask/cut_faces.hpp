// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/constraint.hpp"
#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// Returns this rank's fluid faces that have a neighbour in a body, with where the walls lie between them.
/// `body_of_faces` has the number of the body that each face belongs to, -1 in fluid; a cut face is given to the body
/// that cuts it, so that its constraint force loads this body. Collective.
template <int Dim>
std::vector<CutFace<Dim>> find_cut_faces(const Grid<Dim>& grid, const PosedBodies<Dim>& posed, Vec body_of_faces);

}  // namespace washfsi
