// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/immersed_boundary/transfer.hpp"

namespace washfsi {

/// Sets each face to its nearness to markers at edges, from 1 beside them to 0 beyond the reach of their deltas: from
/// the sum of these, about 0.6 at a wall with markers a cell apart. `at_edges` says which of the transfer's markers are
/// at edges. Collective.
template <int Dim>
void find_edge_nearness(const Grid<Dim>& grid, const Transfer<Dim>& transfer, const std::vector<bool>& at_edges,
                        Vec nearness);

extern template void find_edge_nearness<2>(const Grid<2>&, const Transfer<2>&, const std::vector<bool>&, Vec);
extern template void find_edge_nearness<3>(const Grid<3>&, const Transfer<3>&, const std::vector<bool>&, Vec);

}  // namespace washfsi
