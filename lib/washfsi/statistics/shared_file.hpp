// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "washfsi/support/hdf5_file.hpp"

namespace washfsi {

/// An HDF5 file of data that are the same on all ranks.
class SharedFile {
 public:
  SharedFile(MPI_Comm comm, Hdf5File& file) : comm_(comm), file_(file) {}

  /// A dataset with its unit, slowest index first. Collective.
  void write(const std::string& name, const std::string& unit, const std::vector<hsize_t>& shape,
             const std::vector<double>& values) const;
  Hdf5File& file() const { return file_; }

 private:
  MPI_Comm comm_;
  Hdf5File& file_;
};

/// Writes such a file, completely or not at all. Collective. Errors: FileError.
void write_shared_file(MPI_Comm comm, const std::string& path, const std::function<void(const SharedFile&)>& fill);

}  // namespace washfsi
