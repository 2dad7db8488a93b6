// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <mpi.h>

#include "washfsi/support/slab.hpp"

namespace washfsi {

/// An HDF5 file that all ranks share. All members are collective. Errors, on all ranks: FileError when writing,
/// InputError when reading.
class Hdf5File {
 public:
  enum class Mode { create, read };

  Hdf5File(MPI_Comm comm, const std::string& path, Mode mode);
  ~Hdf5File();
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  /// Writes a new dataset; groups in its name are created.
  void write(const std::string& dataset, const Slab& slab, const std::vector<double>& values);
  void write(const std::string& dataset, const Slab& slab, const std::vector<long long>& values);
  std::vector<double> read(const std::string& dataset, const Slab& slab);
  /// Writes a new dataset with a digest of its values, which reading compares to detect any change.
  void write_sealed(const std::string& dataset, const Slab& slab, const std::vector<double>& values);
  enum class Readers { parts, whole };  ///< whether each rank reads its part, or all of them the same
  std::vector<double> read_sealed(const std::string& dataset, const Slab& slab, Readers readers = Readers::parts);
  /// Whether there is a dataset.
  bool has(const std::string& dataset);
  /// The shape of a whole dataset.
  std::vector<hsize_t> shape(const std::string& dataset);

  /// Sets an attribute of an existing object ("/" is the file itself) to a finite number.
  void set_attribute(const std::string& object, const std::string& name, double value);
  double attribute(const std::string& object, const std::string& name);
  /// Adds a text to an object, for readers.
  void set_text(const std::string& object, const std::string& name, const std::string& text);

  void create_group(const std::string& name);
  /// Makes `name` stand for an object in another file, given by a path from this one's folder.
  void link(const std::string& name, const std::string& file, const std::string& object);

  /// Closes the file and reports errors that only closing detects, such as a full disk.
  void close();

 private:
  void agree(bool succeeded, const std::string& what) const;
  void write(const std::string& dataset, const Slab& slab, hid_t type, const void* values);

  MPI_Comm comm_;
  std::string path_;
  Mode mode_;
  hid_t file_ = -1;
};

/// Makes a folder and its parents; throws FileError on all ranks if it cannot be written to. Collective.
void make_writable_folder(MPI_Comm comm, const std::string& path);

/// Renames a file that is complete on disk, so that one of both names exists whenever the machine stops; `keep`, if
/// any, is a further name for the file that it replaces. On rank 0; returns whether it succeeded.
bool commit_file(const std::string& temporary, const std::string& path, const std::string& keep = "");

/// Removes files in a folder that killed runs left incomplete. On rank 0.
void remove_parts(const std::string& folder);

/// Where a written file must have arrived: on the disk, or in the operating system, where it outlives the process.
enum class Reach { disk, system };

/// Writes a text file on rank 0, completely or not at all. Collective. Errors: FileError on all ranks.
void write_text_file(MPI_Comm comm, const std::string& path, const std::string& text, Reach reach = Reach::disk);

}  // namespace washfsi
