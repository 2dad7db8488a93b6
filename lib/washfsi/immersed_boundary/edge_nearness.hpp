// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "washfsi/immersed_boundary/transfer.hpp"

namespace washfsi {

/// Sets faces from 1 beside the markers at edges to 0 beyond the reach of their deltas: by the sum of the deltas of
/// markers a cell and less apart, some 0.6 at a wall. `at_edges` is of the transfer's markers. Collective.
template <int Dim>
void find_edge_nearness(const Grid<Dim>& grid, const Transfer<Dim>& transfer, const std::vector<bool>& at_edges,
                        Vec nearness);

extern template void find_edge_nearness<2>(const Grid<2>&, const Transfer<2>&, const std::vector<bool>&, Vec);
extern template void find_edge_nearness<3>(const Grid<3>&, const Transfer<3>&, const std::vector<bool>&, Vec);

}  // namespace washfsi
