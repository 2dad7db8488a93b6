// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "washfsi/cloth/cloths.hpp"

namespace washfsi {

/// Writes cloth_final.csv: group, cloth within the group, marker i and j on its lattice, position and velocity of every
/// marker. Collective. Errors: FileError.
template <int Dim>
void write_marker_table(MPI_Comm comm, const std::string& path, const Cloths<Dim>& cloths, const Points<Dim>& positions,
                        const Points<Dim>& velocities);

}  // namespace washfsi
