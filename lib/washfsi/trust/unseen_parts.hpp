// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// A part of a body that holds nothing: its surface passes the box by, in whatever way the body turns.
struct UnseenPart {
  std::string name;          ///< prefix of its options
  bool is_inverted = false;  ///< it would be solid outside its surface
  double nearest = 0;        ///< how far its surface is from the middle of a cell at least [m]
};

/// Of the shapes whose union a body is. None of a body that moves along, which may come into the box. Collective.
template <int Dim>
std::vector<UnseenPart> unseen_parts(const Grid<Dim>& grid, const Body<Dim>& body, double time);

}  // namespace washfsi
