// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <mpi.h>

namespace washfsi {

/// Reads a table of numbers over time, separated by commas; blank lines, those that begin with # and a first row with
/// the names are passed over. `columns` are the names, "time,..."; `option` names the file in errors: InputError if it
/// cannot be read, is malformed, has fewer than two rows or times [s] that do not increase. Collective.
std::vector<std::vector<double>> read_time_table(MPI_Comm comm, const std::string& path, const std::string& option,
                                                 const std::string& columns);

}  // namespace washfsi
