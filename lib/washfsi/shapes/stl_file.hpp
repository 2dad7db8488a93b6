// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include <mpi.h>

#include "washfsi/geometry/nearest.hpp"

namespace washfsi {

/// The facets of an STL file, ASCII or binary; its normals are not used, since the order of the corners tells them.
/// `option` names the file in errors: InputError if it cannot be read, is no STL file, or is cut short. Collective.
std::vector<Triangle> read_stl(MPI_Comm comm, const std::string& path, const std::string& option);

}  // namespace washfsi
