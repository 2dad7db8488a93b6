// SPDX-License-Identifier: BSD-3-Clause
//
// What a checkpoint holds of short arrays that are the same on all ranks.
#pragma once

#include "washfsi/cloth/forces.hpp"
#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

/// Rank 0 writes it. Collective.
void write_shared(Hdf5File& file, MPI_Comm comm, const std::string& name, const std::vector<double>& values);
/// All ranks read all of it, however long it is. Collective.
std::vector<double> read_shared(Hdf5File& file, const std::string& name);

/// The distances at which the contact of what started in contact begins. Collective.
template <int Dim>
void write_contact_distances(Hdf5File& file, const Forces<Dim>& forces);
/// After a run without them they begin anew. Collective.
template <int Dim>
void read_contact_distances(Hdf5File& file, Forces<Dim>& forces);

}  // namespace washfsi
