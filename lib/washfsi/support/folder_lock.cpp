// SPDX-License-Identifier: BSD-3-Clause
#include "washfsi/support/folder_lock.hpp"

#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "washfsi/support/collective.hpp"
#include "washfsi/support/errors.hpp"

namespace washfsi {

FolderLock::FolderLock(MPI_Comm comm, const std::string& folder) : path_(folder + "/.lock") {
  bool taken = false;
  if (rank_of(comm) == 0) {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    taken = file_ >= 0 && flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  }
  if (any_rank(comm, taken)) throw FileError("-output_dir " + folder + ": another run is writing into this folder");
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
  (void)close(file_);
}

}  // namespace washfsi
