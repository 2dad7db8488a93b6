// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "washfsi/grid/grid.hpp"
#include "washfsi/motion/body.hpp"

namespace washfsi {

/// A part of a body without effect: its surface misses the box, however the body turns.
struct UnseenPart {
  std::string name;          ///< prefix of its options
  bool is_inverted = false;  ///< whether it would be solid outside its surface
  double nearest = 0;        ///< least distance of its surface from the middle of a cell [m]
};

/// Finds such parts among the shapes whose union a body is; none of a body with translation, which may come into the
/// box. Collective.
template <int Dim>
std::vector<UnseenPart> unseen_parts(const Grid<Dim>& grid, const Body<Dim>& body, double time);

}  // namespace washfsi
