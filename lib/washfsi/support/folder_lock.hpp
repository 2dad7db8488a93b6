// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <mpi.h>

namespace washfsi {

/// While it lives, no other run may write into a folder: an advisory lock of the operating system on the file `.lock`
/// in it, which a killed run does not leave behind.
class FolderLock {
 public:
  /// Collective. Errors: FileError if another run has it. A file system without locks is not locked.
  FolderLock(MPI_Comm comm, const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::string path_;
  int file_ = -1;  ///< file descriptor on rank 0
};

}  // namespace washfsi
